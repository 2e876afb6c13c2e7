package badlog.lib

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import java.io.File

/** The interval of the thread that handles the log's files. */
private const val TICK_MILLIS = 100L

/** A system that does not rename open files, such as Windows. The first attempt for a file fails; the next one, after closing, succeeds. */
private class RenamesOnlyClosed {
    private val tried = HashSet<File>()

    @Synchronized
    fun move(from: File, to: File): Boolean = !tried.add(from) && from.renameTo(to)
}

private class Match(folder: File, time: TestTime, move: (File, File) -> Boolean) {
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
        it.time = time
    }
}

class RenamedLogSpec : FunSpec({
    beforeTest { inFolder { folder -> standardErrorOf { BadLog.init("$folder/last.bag").close() } } }

    for (isCompressed in listOf(false, true)) {
        val kind = if (isCompressed) "gzipped" else "plain"

        test("if open files cannot be renamed, a $kind log still gets its match's name, and no row is lost") {
            inFolder { folder ->
                val time = TestTime()
                val robot = Match(folder, time, RenamesOnlyClosed()::move)
                robot.options.isCompressed = isCompressed
                var rows = 0L
                val messages = standardErrorOf {
                    RobotLog.start(robot.options).use { log ->
                        BadLog.createTopicLong("Row", "ul", { rows })
                        log.periodic()
                        time.pass(TICK_MILLIS)
                        repeat(500) { log.periodic().also { rows++ } }
                        robot.match = "Q42"
                        // Rows are written while the file is closed and opened again.
                        time.passWhile(TICK_MILLIS) { log.periodic().also { rows++ } }
                        log.file!!.name shouldContain "_OHCL_Q42"
                        repeat(500) { log.periodic().also { rows++ } }
                        log.log.counters().rowsMissed shouldBe 0
                    }
                }
                messages shouldBe ""
                val file = folder.listFiles()!!.single()
                val recording = if (isCompressed) recordingIn(inflated(file.readBytes())) else recordingIn(file)
                val numbers = recording.topics.single { it.name == "Row" }.samples.map { it.toLong() }
                numbers.size.toLong() shouldBe rows
                numbers shouldBe (numbers.first()..numbers.last()).toList()
                recording.topics.single { it.name == "Robot/Events" }.texts.dictionary shouldContain "Match OHCL Q42"
            }
        }
    }

    test("rows are written while the system renames the log slowly") {
        inFolder { folder ->
            val time = TestTime()
            val disk = HeldDevice()
            val robot = Match(folder, time) { from, to ->
                disk.hold()
                from.renameTo(to)
            }
            RobotLog.start(robot.options).use { log ->
                log.periodic()
                time.pass(TICK_MILLIS)
                robot.match = "Q42"
                var rowsMeanwhile = 0
                time.passWhile(TICK_MILLIS) {
                    log.periodic()
                    if (disk.isHolding && ++rowsMeanwhile == 100) disk.release()
                }
                log.file!!.name shouldContain "_OHCL_Q42"
                disk.isWaitedFor shouldBe false
                log.log.counters().rowsMissed shouldBe 0
            }
        }
    }

    test("a log that cannot be renamed keeps its name and rows, and notes the match") {
        inFolder { folder ->
            val time = TestTime()
            val robot = Match(folder, time) { _, _ -> false }
            val messages = standardErrorOf {
                RobotLog.start(robot.options).use { log ->
                    log.periodic()
                    time.pass(TICK_MILLIS)
                    robot.match = "Q42"
                    time.pass(TICK_MILLIS)
                    log.periodic()
                    log.file!!.readText() shouldContain "Match OHCL Q42"
                    log.file!!.readText() shouldContain "could not be renamed"
                    log.log.counters().rowsMissed shouldBe 0
                }
            }
            messages shouldContain "could not be renamed to FRC_"
            folder.list()!!.single() shouldStartWith "FRC_2"
        }
    }

    test("a reopened file continues after its last row, and a closed one stays closed") {
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
