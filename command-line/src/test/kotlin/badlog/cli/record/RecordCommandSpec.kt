package badlog.cli.record

import badlog.cli.BAG
import badlog.cli.Ended
import badlog.cli.IF_INTERRUPTS
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogBeside
import badlog.cli.besideRobot
import badlog.cli.command.ExitCode
import badlog.cli.interrupt
import badlog.cli.plugin.javaCommand
import badlog.cli.with
import badlog.core.analysis.LogView
import badlog.core.waiting.eventually
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.networktables.replay.ReplayOptions
import badlog.networktables.replay.ReplayServer
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldMatch
import kotlinx.serialization.json.jsonPrimitive
import kotlinx.serialization.json.long
import java.net.ServerSocket
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import kotlin.concurrent.thread
import kotlin.io.path.exists
import kotlin.io.path.fileSize
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

@Tags("InCheck")
class RecordCommandSpec : FunSpec({
    /** A robot that publishes a match, again and again. */
    fun besideReplay(work: suspend (robot: String) -> Unit): suspend () -> Unit = {
        val view = LogView.of(readRecording(SAMPLES.resolve("qualification-42.bag"), LOG_FORMATS))
        ReplayServer(view, ReplayOptions(0, isLooping = true)).use { robot ->
            robot.start()
            work("127.0.0.1:${robot.port}")
        }
    }

    fun Path.logs(): List<Path> = if (exists()) listDirectoryEntries().filter { it.name.endsWith(".wpilog") } else emptyList()

    /** Records with [arguments] until [isEnough] of the folder, and returns what the program said. */
    fun recorded(folder: Path, vararg arguments: Any, isEnough: () -> Boolean = { folder.logs().any { it.fileSize() > 50_000 } }): Ended {
        var ended: Ended? = null
        val program = thread { ended = badlog("record", *arguments, "--out", folder) }
        eventually("what is to be recorded", isEnough)
        program.interrupt()
        program.join()
        return ended!!
    }

    test("published values are in the log, and the last line has their number and the log's place") {
        besideReplay { robot ->
            inFolder { folder ->
                val ended = recorded(folder.resolve("logs"), robot)
                ended.code shouldBe ExitCode.WHOLE
                val log = folder.resolve("logs").logs().single()
                ended.out shouldMatch Regex("""\Q$log\E: [\d,]+ values of [\d,]+ topics, [\d.]+ kB\n""")
                ended.err shouldBe "Looking for the robot at 127.0.0.1; Ctrl+C ends it.\nConnected to the robot at $robot.\n"
                val recording = readRecording(log, LOG_FORMATS)
                recording.topics.map { it.name } shouldContain "NT:/System/Battery Voltage"
                recording.topics.single { it.name == "NT:/System/Battery Voltage" }.unit shouldBe "V"
                badlog("find", log, "min(battery) > 5", "--no-cache").code shouldBe ExitCode.WHOLE
            }
        }()
    }

    test("--only records matching topics, by their name in the log or on the robot") {
        besideReplay { robot ->
            inFolder { folder ->
                for ((index, pattern) in listOf("NT:/PDP/*", "/pdp/*", "PDP/*").withIndex()) {
                    val logs = folder.resolve("$index")
                    recorded(logs, robot, "--only", pattern) { logs.logs().any { it.fileSize() > 10_000 } }
                    val names = readRecording(logs.logs().single(), LOG_FORMATS).topics.map { it.name }
                    names shouldContain "NT:/PDP/Total Current"
                    names shouldNotContain "NT:/System/Battery Voltage"
                }
            }
        }()
    }

    test("a program only gets a line for each log") {
        besideReplay { robot ->
            inFolder { folder ->
                val ended = recorded(folder, robot, "--json")
                ended.err shouldBe ""
                val line = ended.json.single()
                line.getValue("command").jsonPrimitive.content shouldBe "record"
                line.getValue("status").jsonPrimitive.content shouldBe "whole"
                line.getValue("file").jsonPrimitive.content shouldBe "${folder.logs().single()}"
                line.getValue("values").jsonPrimitive.long shouldBeGreaterThan 100
                line.getValue("gaps").jsonPrimitive.long shouldBe 0
            }
        }()
    }

    test("without a robot, no log is written, and a sentence has the reason") {
        inFolder { folder ->
            ServerSocket(0).use { nobody ->
                val tries = AtomicInteger()
                thread { runCatching { while (true) nobody.accept().use { tries.incrementAndGet() } } }
                val ended = recorded(folder, "127.0.0.1:${nobody.localPort}") { tries.get() > 1 }
                ended.code shouldBe ExitCode.NOTHING
                ended.out shouldBe ""
                ended.err shouldContain "No NetworkTables server answered at 127.0.0.1"
                folder.logs() shouldBe emptyList()
            }
        }
    }

    test("a folder that cannot be made is reported, and ends it") {
        besideReplay { robot ->
            inFolder { folder ->
                val ended = badlog("record", robot, "--out", folder.with("file", BAG))
                ended.code shouldBe ExitCode.NOTHING
                ended.err shouldContain "The log cannot be written"
            }
        }()
    }

    test("a team's robot is found where fetch finds it") {
        besideRobot { _, robots ->
            inFolder { folder ->
                val program = thread { badlogBeside(robots, "record", "1014", "--out", folder) }
                fun names() = folder.logs().flatMap { log -> readRecording(log, LOG_FORMATS).topics.map { it.name } }
                eventually("what the robot publishes") { "NT:/FMSInfo/FMSControlData" in names() }
                program.interrupt()
                program.join()
                names() shouldContain "NT:/FMSInfo/FMSControlData"
            }
        }
    }

    test("Ctrl+C closes the log and says where it is").config(enabledOrReasonIf = { IF_INTERRUPTS }) {
        besideReplay { robot ->
            inFolder { folder ->
                val process = ProcessBuilder(javaCommand("record", robot, "--out", "$folder")).redirectErrorStream(true).start()
                try {
                    eventually("the log") { folder.logs().any { it.fileSize() > 50_000 } }
                    interrupt(process)
                    val said = process.inputStream.bufferedReader().readLines()
                    process.waitFor(1, TimeUnit.MINUTES) shouldBe true
                    val log = folder.logs().single()
                    said.last() shouldMatch Regex("""\Q$log\E: [\d,]+ values of [\d,]+ topics, .*""")
                    readRecording(log, LOG_FORMATS).problems.filter { "cut" in it.message } shouldBe emptyList()
                } finally {
                    process.destroyForcibly()
                }
            }
        }()
    }
})
