package badlog.networktables.record

import badlog.core.waiting.eventually
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldMatch
import java.nio.ByteBuffer
import java.nio.ByteOrder
import kotlin.io.path.exists
import kotlin.io.path.name

/** Tests of the number and content of recorded files. */
@Tags("InCheck")
class RecordedFilesSpec : FunSpec({
    test("each enabled period gets a log with the current values at its start and the match in its name") {
        FakeServer().use { server ->
            server.greeting = {
                announceControl()
                announce("/A", 1, "double")
                announce("/FMSInfo/EventName", 2, "string")
                announce("/FMSInfo/MatchType", 3, "int")
                announce("/FMSInfo/MatchNumber", 4, "int")
                number(1, 1.0)
                value(2, 4) { packString("Mill/Creek") }
                value(3, 2) { packLong(2) }
                value(4, 2) { packLong(42) }
                enable(false)
            }
            recording(server, isPerEnable = true) { running ->
                eventually("the recorder to subscribe") { server.greeted.get() == 1 }
                server.number(1, 2.0)
                server.enable(true)
                server.number(1, 3.0)
                eventually("the values to be written") { running.recorder.progress.values == 6L }
                running.files.shouldBeEmpty()
                val log = running.logs().single()
                log.entry("NT:/A").numbers() shouldBe listOf(2.0, 3.0)
                log.entry("NT:/FMSInfo/FMSControlData").longs() shouldBe listOf(33L)
                running.files.single().path.name shouldMatch Regex("""FRC_\d{8}_\d{6}_Mill-Creek_Q42\.wpilog""")
                running.files.single().path.exists() shouldBe true
            }
        }
    }

    test("without renaming, only a log that begins during a match has the match in its name") {
        FakeServer().use { server ->
            server.greeting = {
                announceControl()
                announce("/FMSInfo/MatchType", 3, "int")
                announce("/FMSInfo/MatchNumber", 4, "int")
                value(3, 2) { packLong(2) }
                value(4, 2) { packLong(42) }
                enable(false)
            }
            recording(server, isRenamed = false) { running ->
                eventually("the values to be written") { running.recorder.progress.values == 3L }
                running.logs().single().entry("NT:/FMSInfo/MatchNumber").longs() shouldBe listOf(42L)
                running.files.single().path.name shouldMatch Regex("""FRC_\d{8}_\d{6}\.wpilog""")
            }
            recording(server, isPerEnable = true, isRenamed = false) { running ->
                eventually("the recorder to subscribe") { server.greeted.get() == 2 }
                server.enable(true)
                eventually("the values to be written") { running.recorder.progress.values == 3L }
                running.logs()
                running.files.single().path.name shouldMatch Regex("""FRC_\d{8}_\d{6}_Q42\.wpilog""")
            }
        }
    }

    for (folder in listOf("/FMSInfo", "/DriverStation")) {
        test("from 2027 on, whether the robot is enabled and which match it plays come from $folder/ControlWord, a struct") {
            FakeServer().use { server ->
                fun control(isEnabled: Boolean) {
                    // The op mode is in the lower 56 bits, the mode in the next two. Then come enabled, emergency stop, field and Driver
                    // Station.
                    val word = 0x00AB_CDEF_0123_4567L or (2L shl 56) or ((if (isEnabled) 1L else 0L) shl 58) or (1L shl 61)
                    server.value(99, 5) {
                        packBinaryHeader(8)
                        writePayload(ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN).putLong(word).array())
                    }
                }
                server.greeting = {
                    announce("$folder/ControlWord", 99, "struct:ControlWord")
                    announce("/A", 1, "double")
                    announce("$folder/MatchType", 3, "int")
                    announce("$folder/MatchNumber", 4, "int")
                    number(1, 1.0)
                    value(3, 2) { packLong(2) }
                    value(4, 2) { packLong(42) }
                    control(false)
                }
                recording(server, isPerEnable = true) { running ->
                    eventually("the recorder to subscribe") { server.greeted.get() == 1 }
                    server.number(1, 2.0)
                    control(true)
                    server.number(1, 3.0)
                    eventually("the values to be written") { running.recorder.progress.values == 5L }
                    running.logs().single().entry("NT:/A").numbers() shouldBe listOf(2.0, 3.0)
                    running.files.single().path.name shouldMatch Regex(""".*_Q42\.wpilog""")
                }
            }
        }
    }

    test("several servers with different clocks are recorded into one log with the robot's clock") {
        val clock = StillClock()
        FakeServer(offset = 10_000_000, clock = clock).use { robot ->
            FakeServer(offset = 900_000_000, clock = clock).use { station ->
                robot.greeting = { announce("/A", 1, "double") }
                station.greeting = { announce("/Dscomm/Battery", 1, "double") }
                recording(robot, station) { running ->
                    eventually("the recorder to subscribe") { robot.greeted.get() == 1 && station.greeted.get() == 1 }
                    repeat(5) {
                        robot.number(1, 1.0)
                        station.number(1, 12.5)
                        clock.advance(1_000)
                    }
                    eventually("the values to be written") { running.recorder.progress.values == 10L }
                    val log = running.logs().single()
                    log.entry("NT:/A").times() shouldBe List(5) { 11.0 + it / 1e3 }
                    log.entry("DS:/Dscomm/Battery").times() shouldBe List(5) { 11.0 + it / 1e3 }
                    log.entry("Recorder/Connected DS").truths() shouldBe listOf(true)
                }
            }
        }
    }

    test("a topic that a mirror repeats is recorded once, from the robot, regardless of which server announces it first") {
        val clock = StillClock()
        FakeServer(clock = clock).use { robot ->
            FakeServer(clock = clock).use { mirror ->
                robot.greeting = {
                    announce("/A", 1, "double")
                    number(1, 1.0)
                }
                mirror.greeting = {
                    announce("/A", 1, "double")
                    announce("/B", 2, "double")
                    announce("/Own", 3, "double")
                    for (id in 1..3) number(id, 2.0)
                }
                recording(robot, mirror) { running ->
                    eventually("the recorder to subscribe") { robot.greeted.get() == 1 && mirror.greeted.get() == 1 }
                    eventually("the values to be written") { running.recorder.progress.values >= 3 }
                    robot.announce("/B", 2, "double")
                    robot.number(2, 1.0)
                    running.awaitOnDisk(clock) { log -> log.entries.any { it.name == "NT:/B" && it.size == 1 } }
                    mirror.number(1, 3.0)
                    mirror.number(2, 3.0)
                    mirror.number(3, 3.0)
                    running.awaitOnDisk(clock) { it.entry("DS:/Own").size == 2 }
                    val log = running.logs().single()
                    log.entry("NT:/A").numbers() shouldBe listOf(1.0)
                    log.entry("NT:/B").numbers() shouldBe listOf(1.0)
                    log.entries.filter { it.name == "DS:/A" || it.name == "DS:/B" }.flatMap { it.numbers() }.contains(3.0) shouldBe false
                }
            }
        }
    }

    test("a new log does not take the name of an existing one") {
        FakeServer().use { server ->
            recording(server) { running ->
                val names = ArrayList<String>()
                repeat(3) {
                    Running(running.folder, listOf(RecordedServer("robot", "NT:") { ServerAddress("127.0.0.1", server.port) }), RecordOptions(running.folder), server.clock).use {
                        it.recorder.start()
                        eventually("the connection") { it.count("connected") == 1 }
                        it.close()
                        val name = it.files.single().path.name
                        names shouldNotContain name
                        names += name
                    }
                }
            }
        }
    }
})
