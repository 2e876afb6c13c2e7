package badlog.lib

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import java.io.File

/** A system that renames no open file, as Windows: it says no until the file was tried once, and then renames the closed one. */
private class RenamesOnlyClosed {
    private val tried = HashSet<File>()

    @Synchronized
    fun move(from: File, to: File): Boolean = !tried.add(from) && from.renameTo(to)
}

private class Match(folder: File, move: (File, File) -> Boolean) {
    @Volatile
    var match = ""

    val options = RobotLogOptions().also {
        it.folder = folder
        it.isEnabled = { true }
        it.isDriverStationAttached = { true }
        it.isClockSet = { true }
        it.event = { if (match.isEmpty()) "" else "OHCL" }
        it.match = { match }
        it.batteryVoltage = null
        it.move = move
    }
}

class RenamedLogSpec : FunSpec({
    beforeTest { inFolder { folder -> standardErrorOf { BadLog.init("$folder/last.bag").close() } } }

    for (isCompressed in listOf(false, true)) {
        val kind = if (isCompressed) "gzipped" else "plain"

        test("where an open file cannot be renamed, a $kind log gets its match's name, and no row is lost") {
            inFolder { folder ->
                val robot = Match(folder, RenamesOnlyClosed()::move)
                robot.options.isCompressed = isCompressed
                var rows = 0L
                val said = standardErrorOf {
                    RobotLog.start(robot.options).use { log ->
                        BadLog.createTopicLong("Row", "ul", { rows })
                        until({ log.log.counters().rowsWritten > 0 }) { log.periodic() }
                        rows++
                        // Without a pause: rows are written while the file is closed and opened again.
                        repeat(500) { log.periodic().also { rows++ } }
                        robot.match = "Q42"
                        until({ "_OHCL_Q42" in log.file!!.name }) { log.periodic().also { rows++ } }
                        repeat(500) { log.periodic().also { rows++ } }
                        log.log.counters().rowsMissed shouldBe 0
                    }
                }
                said shouldBe ""
                val file = folder.listFiles()!!.single()
                val recording = if (isCompressed) recordingIn(inflated(file.readBytes())) else recordingIn(file)
                val numbers = recording.topics.single { it.name == "Row" }.samples.map { it.toLong() }
                numbers.size shouldBeGreaterThan 1000
                numbers shouldBe (numbers.first()..numbers.last()).toList()
                recording.topics.single { it.name == "Robot/Events" }.texts.dictionary shouldContain "Match OHCL Q42"
            }
        }
    }

    test("a log that cannot be renamed at all keeps its name and its rows, and has the match") {
        inFolder { folder ->
            val robot = Match(folder) { _, _ -> false }
            val said = standardErrorOf {
                RobotLog.start(robot.options).use { log ->
                    until({ log.log.state == LogState.LOGGING }) { log.periodic() }
                    robot.match = "Q42"
                    until({ "Match OHCL Q42" in log.file!!.readText() }) { log.periodic() }
                    until({ "could not be renamed" in log.file!!.readText() }) { log.periodic() }
                    log.log.counters().rowsMissed shouldBe 0
                }
            }
            said shouldContain "could not be renamed to FRC_"
            folder.list()!!.single() shouldStartWith "FRC_2"
        }
    }

    test("a row goes on behind the last one in a file that was reopened, and one that was closed stays closed") {
        inFolder { folder ->
            val system = RenamesOnlyClosed()
            val file = AppendFile(File(folder, "a"), system::move)
            val bytes = "one\n".encodeToByteArray()
            file.append(bytes, bytes.size)
            file.rename(File(folder, "b"), this) shouldBe true
            file.append(bytes, bytes.size)
            file.sync()
            File(folder, "b").readText() shouldBe "one\none\n"
            file.length shouldBe 8
            file.close()
            file.rename(File(folder, "c"), this) shouldBe false
            folder.list()!!.toList() shouldBe listOf("b")
        }
    }
})
