package badlog.lib

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldMatch
import java.io.File
import java.util.function.Supplier

/** A robot with a state that the test sets. Its loop takes 10 ms. */
private class Robot(folder: File) {
    val time = TestTime()

    @Volatile
    var enabled = false

    @Volatile
    var attached = false

    @Volatile
    var clockSet = false

    @Volatile
    var event = ""

    @Volatile
    var match = ""

    @Volatile
    var free = 1_000_000_000L

    val options = RobotLogOptions().also {
        it.folder = folder
        it.isEnabled = { enabled }
        it.isDriverStationAttached = { attached }
        it.isClockSet = { clockSet }
        it.event = { event }
        it.match = { match }
        it.batteryVoltage = { 12.5 }
        it.freeBytes = { free }
        it.time = time
    }

    fun drive(log: RobotLog, millis: Int = TICK_MILLIS) = repeat(millis / 10) {
        time.pass(10)
        log.periodic()
    }
}

/** The interval of the thread that handles the log's files. */
private const val TICK_MILLIS = 100

private fun File.names() = list().orEmpty().sorted()

class RobotLogSpec : FunSpec({
    // Robots of other specs never close their logs, like real robots.
    beforeTest { inFolder { folder -> standardErrorOf { BadLog.init("$folder/last.bag").close() } } }

    test("nothing is written until a driver station is connected; then time, event and match make the name") {
        inFolder { folder ->
            val logs = File(folder, "logs")
            val robot = Robot(logs)
            val messages = standardErrorOf {
                RobotLog.start(robot.options).use { log ->
                    BadLog.createTopicDouble("Own", "V", { 1.0 })
                    robot.drive(log, 300)
                    logs.exists() shouldBe false
                    log.file shouldBe null

                    robot.attached = true
                    robot.drive(log)
                    log.log.state shouldBe LogState.LOGGING
                    logs.names().single() shouldMatch "FRC_TBD_[0-9a-f]{16}\\.bag"
                    shouldThrow<InvalidModeException> { BadLog.createTopicDouble("Late", "V", { 1.0 }) }

                    robot.clockSet = true
                    robot.drive(log)
                    logs.names().single() shouldMatch "FRC_\\d{8}_\\d{6}\\.bag"

                    robot.event = "OHCL"
                    robot.match = "Q42"
                    robot.enabled = true
                    robot.drive(log)
                    log.file!!.readText() shouldContain "Match OHCL Q42"
                    logs.names().single() shouldMatch "FRC_\\d{8}_\\d{6}_OHCL_Q42\\.bag"
                    log.file?.name shouldBe logs.names().single()
                    log.log.state shouldBe LogState.LOGGING
                }
            }
            messages shouldBe ""
            val recording = recordingIn(logs.listFiles()!!.single())
            recording.topics.map { it.name } shouldBe
                listOf("Time", "Robot/Enabled", "Robot/Battery Voltage", "Robot/Events", "Own")
            recording.topics[3].texts.dictionary shouldBe listOf("Match OHCL Q42")
            val times = recording.topics[0].samples.toList()
            times shouldBe times.sorted().distinct()
        }
    }

    test("a disabled robot logs four rows a second, an enabled one every loop") {
        inFolder { folder ->
            val robot = Robot(folder).apply { attached = true }
            RobotLog.start(robot.options).use { log ->
                robot.drive(log)

                /** Whether the call logged a row. */
                fun isRow(): Boolean {
                    val before = log.log.counters().rowsWritten
                    log.periodic()
                    return log.log.counters().rowsWritten > before
                }
                robot.time.pass(250)
                isRow() shouldBe true
                repeat(4) {
                    isRow() shouldBe false
                    robot.time.pass(249)
                    isRow() shouldBe false
                    robot.time.pass(1)
                    isRow() shouldBe true
                }
                robot.enabled = true
                repeat(100) { isRow() shouldBe true }
                robot.enabled = false
                // The row that shows the robot disabled.
                isRow() shouldBe true
                isRow() shouldBe false
            }
        }
    }

    test("the header has everything known by then; it is written once the robot is enabled or after a wait") {
        inFolder { folder ->
            for (begin in listOf<Robot.() -> Unit>({ enabled = true }, { options.headerTimeout = 1.0 })) {
                val robot = Robot(File(folder, "logs")).apply {
                    clockSet = true
                    event = "A/B: C"
                    match = "E3"
                    options.isCompressed = true
                    begin()
                }
                RobotLog.start(robot.options).use {
                    robot.drive(it, 1000)
                    it.log.state shouldBe LogState.LOGGING
                }
            }
            val names = File(folder, "logs").names()
            names.size shouldBe 2
            names.forEach { it shouldMatch "FRC_\\d{8}_\\d{6}_ABC_E3(_2)?\\.bag\\.gz" }
            recordingIn(inflated(File(folder, "logs/${names[0]}").readBytes())).values.map { "$it" } shouldBe listOf(
                "Value(name=Event Name, text=A/B: C)",
                "Value(name=Match Type, text=Elimination)",
                "Value(name=Match Number, text=3)",
            )
        }
    }

    test("the oldest logs are deleted when space is short, but ten are kept and nothing else is touched") {
        inFolder { folder ->
            val robot = Robot(folder).apply {
                enabled = true
                options.freeBytes = { 20_000_000L }
            }
            for (day in 1..15) {
                val log = File(folder, "FRC_202603%02d_120000.bag".format(day))
                log.writeText("x")
                log.setLastModified(day * 1000L)
            }
            File(folder, "notes.bag").writeText("x")
            File(folder, "FRC_20260301_120000.wpilog").writeText("x")
            File(folder, "FRC_TBD_0.bag").writeText("x")
            standardErrorOf {
                RobotLog.start(robot.options).use { log -> robot.drive(log) }
            } shouldContain "deleted: FRC_TBD_0.bag, FRC_20260301_120000.bag, FRC_20260302_120000.bag, and 3 more."
            folder.names().filter { it.startsWith("FRC_2") && it.endsWith(".bag") } shouldBe
                (6..15).map { "FRC_202603%02d_120000.bag".format(it) }
            File(folder, "FRC_TBD_0.bag").exists() shouldBe false
            File(folder, "notes.bag").exists() shouldBe true
            File(folder, "FRC_20260301_120000.wpilog").exists() shouldBe true
        }
    }

    test("nothing is logged to an almost full disk, at the start or later") {
        inFolder { folder ->
            val robot = Robot(folder).apply {
                enabled = true
                free = 4_000_000
            }
            standardErrorOf {
                RobotLog.start(robot.options).use { log ->
                    robot.drive(log)
                    log.log.state shouldBe LogState.CLOSED
                }
            } shouldContain "less than 5 MiB"
            folder.names().shouldBeEmpty()

            robot.free = 100_000_000
            standardErrorOf {
                RobotLog.start(robot.options).use { log ->
                    robot.drive(log)
                    log.log.state shouldBe LogState.LOGGING
                    robot.free = 5_000_000
                    // The free space is checked every five seconds.
                    robot.drive(log, 5000)
                    log.log.state shouldBe LogState.CLOSED
                    robot.drive(log)
                }
            } shouldContain "less than 5 MiB"
            val recording = recordingIn(folder.listFiles()!!.single())
            recording.topics.first { it.name == "Robot/Events" }.texts.dictionary.last() shouldContain "Logging stopped: less than 5 MiB"
        }
    }

    test("a log closed before it begins leaves no file") {
        inFolder { folder ->
            var log: RobotLog? = null
            val robot = Robot(folder).apply { enabled = true }
            robot.options.event = Supplier {
                log?.close()
                ""
            }
            standardErrorOf {
                log = RobotLog.start(robot.options)
                robot.drive(log)
                log.log.state shouldBe LogState.CLOSED
            } shouldBe ""
            folder.names().shouldBeEmpty()

            val session = LogSession(flushesEachRow = true)
            session.close()
            session.begin(File(folder, "late.bag"), false)
            session.open(File(folder, "late.bag"), true)
            session.file shouldBe null
            folder.names().shouldBeEmpty()
        }
    }

    test("an idle robot begins to log after a minute") {
        inFolder { folder ->
            val robot = Robot(folder)
            RobotLog.start(robot.options).use { log ->
                robot.drive(log, 59_000)
                log.log.state shouldBe LogState.SETTING_UP
                robot.drive(log, 1000)
                log.log.state shouldBe LogState.LOGGING
            }
        }
    }

    test("a slow query for free space does not delay the loop") {
        inFolder { folder ->
            val disk = HeldDevice()
            val robot = Robot(folder).apply { enabled = true }
            robot.options.freeBytes = {
                disk.hold()
                1_000_000_000
            }
            RobotLog.start(robot.options).use { log ->
                BadLog.createTopicSubscriber("Published", "ul", DataInferMode.LAST)
                log.periodic()
                var loopsMeanwhile = 0
                robot.time.passWhile(TICK_MILLIS.toLong()) {
                    BadLog.publish("Published", 1.0)
                    log.periodic()
                    if (disk.isHolding && ++loopsMeanwhile == 100) disk.release()
                }
                disk.isWaitedFor shouldBe false
                log.log.state shouldBe LogState.LOGGING
            }
        }
    }

    test("a missing folder is not full") {
        LogFolder(File("none"), File::getUsableSpace).isFull shouldBe false
    }

    test("suppliers that throw do not stop the log") {
        inFolder { folder ->
            val robot = Robot(folder).apply {
                options.headerTimeout = 1.0
                options.isEnabled = { error("no driver station") }
                options.event = { error("no event") }
                options.isClockSet = { error("no clock") }
                options.batteryVoltage = null
            }
            standardErrorOf {
                RobotLog.start(robot.options).use { log ->
                    robot.drive(log, 1500)
                    log.log.state shouldBe LogState.LOGGING
                    log.log.counters().rowsMissed shouldBe 0
                }
            } shouldContain "no driver station"
        }
    }

    test("the folder is the requested one, a stick's, the robot's, or beside the program") {
        inFolder { folder ->
            val stick = File(folder, "u").apply { mkdir() }
            val home = File(folder, "home").apply { mkdir() }
            val none = File(folder, "none")
            val second = File(folder, "V").apply { mkdir() }
            LogFolder.choose(none, listOf(stick), listOf(home)) shouldBe none
            LogFolder.choose(null, listOf(none, second, stick), listOf(home)) shouldBe File(second, "logs")
            LogFolder.choose(null, listOf(stick), listOf(home)) shouldBe File(stick, "logs")
            LogFolder.choose(null, listOf(none), listOf(none, home)) shouldBe File(home, "logs")
            LogFolder.choose(null, listOf(none), listOf(none)) shouldBe File(File("").absoluteFile, "logs")
        }
    }
})
