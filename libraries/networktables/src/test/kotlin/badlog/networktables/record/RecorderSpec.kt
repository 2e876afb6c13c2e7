package badlog.networktables.record

import badlog.core.waiting.eventually
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldMatch
import java.util.concurrent.atomic.AtomicInteger
import kotlin.io.path.name
import kotlin.io.path.writeText

@Tags("InCheck")
class RecorderSpec : FunSpec({
    test("entries are named, typed and described as WPILib's own logger does, and end when their topics do") {
        FakeServer().use { server ->
            server.greeting = {
                announce("/Arm/Angle", 1, "double", """{"unit":"deg","retained":true}""")
                announce("/Count", 2, "int")
                announce("/Counts", 3, "int[]")
                announce("/.schema/struct:P", 4, "structschema")
                announce("/Pose", 5, "struct:P")
                number(1, 2.5)
                value(2, 2) { packLong(7) }
                value(3, 18) { packArrayHeader(1).packLong(8) }
                value(4, 5) { packBinaryHeader(8).writePayload("double x".encodeToByteArray()) }
                value(5, 5) { packBinaryHeader(8).writePayload(ByteArray(8)) }
            }
            recording(server) { running ->
                eventually("the values to be written") { running.recorder.progress.values == 5L }
                server.sendText("""[{"method":"properties","params":{"name":"/Arm/Angle","ack":true,"update":{"retained":null,"unit":"rad"}}}]""")
                server.sendText("""[{"method":"unannounce","params":{"name":"/Count","id":2}}]""")
                server.announce("/Count", 6, "double")
                server.number(6, 9.0)
                eventually("the values to be written") { running.recorder.progress.values == 6L }
                val log = running.logs().single()
                log.entry("NT:/Arm/Angle").metadata shouldBe """{"properties":{"unit":"rad"},"source":"NT"}"""
                log.entry("NT:/Arm/Angle").numbers() shouldBe listOf(2.5)
                log.entries.filter { it.name == "NT:/Count" }.map { it.type } shouldBe listOf("int64", "double")
                log.entry("NT:/Counts").type shouldBe "int64[]"
                log.entry("NT:/.schema/struct:P").texts() shouldBe listOf("double x")
                log.entry("Recorder/Connected").truths() shouldBe listOf(true)
                running.files.single().run {
                    path.name shouldMatch Regex("""FRC_\d{8}_\d{6}\.wpilog""")
                    values shouldBe 6
                    topics shouldBe 6
                    gaps shouldBe 0
                }
                // badlog's own reader decodes the log.
                val recording = readRecording(running.files.single().path, LOG_FORMATS)
                recording.problems.map { it.message } shouldBe listOf("Two topics are named “NT:/Count”; the second is shown as “NT:/Count (2)”.")
                recording.topics.single { it.name == "NT:/Pose/x" }.size shouldBe 1
                recording.topics.single { it.name == "NT:/Arm/Angle" }.unit shouldBe "rad"
                recording.values.map { it.name } shouldContain "Start Time"
            }
        }
    }

    test("the recorder sends only subscriptions and requests for the time") {
        FakeServer().use { server ->
            recording(server) { eventually("the recorder to subscribe") { server.greeted.get() == 1 } }
            server.requests.toList().joinToString("") shouldBe
                """[{"method":"subscribe","params":{"topics":[""],"subuid":1,"options":{"periodic":0.05,"prefix":true,"all":true}}}]"""
        }
    }

    test("times are the server's, and a value set before the log began is written at its start") {
        FakeServer().use { server ->
            recording(server) { running ->
                eventually("the recorder to subscribe") { server.greeted.get() == 1 }
                val now = server.micros
                server.announce("/Old", 1, "double")
                server.announce("/New", 2, "double")
                server.number(1, 1.0, micros = 1000)
                server.number(2, 1.0, now + 123_456)
                server.number(2, 2.0, now + 123_999)
                eventually("the values to be written") { running.recorder.progress.values == 3L }
                val log = running.logs().single()
                log.entry("NT:/New").times() shouldBe listOf((now + 123_456) / 1e6, (now + 123_999) / 1e6)
                val start = log.entry("Recorder/Connected").time(0)
                log.entry("NT:/Old").times() shouldBe listOf(start)
                start shouldBe now / 1e6
            }
        }
    }

    test("sent values are on the disk during the recording") {
        FakeServer().use { server ->
            server.greeting = { announce("/A", 1, "double") }
            recording(server) { running ->
                eventually("the recorder to subscribe") { server.greeted.get() == 1 }
                repeat(3) { round ->
                    server.number(1, round.toDouble())
                    running.awaitOnDisk(server.clock) { log -> log.entries.any { it.name == "NT:/A" && it.size == round + 1 } }
                }
            }
        }
    }

    test("the log shows a lost connection, and repeated values are not written twice") {
        FakeServer().use { server ->
            val times = HashMap<Int, Long>()
            server.greeting = {
                announce("/A", 1, "double")
                announce("/B", 2, "double")
                number(1, 4.0, times.getOrPut(1) { micros })
                number(2, 5.0, times.getOrPut(2) { micros })
            }
            recording(server) { running ->
                eventually("the values to be written") { running.recorder.progress.values == 2L }
                times.remove(2)
                server.clock.advance(1_000_000)
                server.drop()
                eventually("the connection") { running.count("connected") == 2 }
                eventually("the values to be written") { running.recorder.progress.values == 3L }
                val log = running.logs().single()
                log.entry("Recorder/Connected").truths() shouldBe listOf(true, false, true)
                log.entry("NT:/A").size shouldBe 1
                log.entry("NT:/B").size shouldBe 2
                log.entry("messages").texts().any { "was lost" in it } shouldBe true
                running.files.single().gaps shouldBe 1
                running.files.single().late shouldBe 0
            }
        }
    }

    test("a robot with a restarted clock gets a new log, with or without a lost connection") {
        FakeServer().use { server ->
            server.greeting = {
                announce("/A", 1, "double")
                number(1, micros / 1e6)
            }
            server.offset += 1_000_000_000
            recording(server) { running ->
                eventually("the values to be written") { running.recorder.progress.values == 1L }
                // Restarted.
                server.offset -= 1_000_000_000
                server.drop()
                eventually("the values to be written") { running.recorder.progress.values == 2L }
                // Set while connected.
                server.offset += 500_000_000
                eventually("the values to be written") { running.recorder.progress.values == 3L }
                val logs = running.logs()
                logs.size shouldBe 3
                logs.map { it.entry("NT:/A").size } shouldBe listOf(1, 1, 1)
                for (log in logs) {
                    val times = log.entries.flatMap { it.times() }
                    (times.max() - times.min() < 100) shouldBe true
                }
                (logs[0].entry("NT:/A").time(0) > logs[2].entry("NT:/A").time(0)) shouldBe true
                (logs[2].entry("NT:/A").time(0) > logs[1].entry("NT:/A").time(0)) shouldBe true
                running.files.map { it.path.name }.toSet().size shouldBe 3
                running.count("The clock of the robot began anew") shouldBe 2
            }
        }
    }

    test("values with earlier times are written, counted and reported once") {
        FakeServer().use { server ->
            server.greeting = { announce("/A", 1, "double") }
            recording(server) { running ->
                eventually("the recorder to subscribe") { server.greeted.get() == 1 }
                val now = server.micros
                for (micros in listOf(3000, 2000, 4000, 1000)) server.number(1, 0.0, now + micros)
                eventually("the values to be written") { running.recorder.progress.values == 4L }
                val log = running.logs().single()
                // badlog's reader sorts the samples.
                log.entry("NT:/A").times() shouldBe listOf(1000, 2000, 3000, 4000).map { (now + it) / 1e6 }
                running.files.single().late shouldBe 2
                log.entry("messages").texts().filter { "earlier" in it }.size shouldBe 2
            }
        }
    }

    test("only the selected topics and those that every log needs are subscribed to") {
        FakeServer().use { server ->
            server.greeting = {
                announce("/A", 1, "double")
                announce("/B", 2, "double")
                announceControl()
                announce("/.schema/struct:P", 4, "structschema")
                for (id in 1..2) number(id, 1.0)
                enable(false)
                value(4, 5) { packBinaryHeader(1).writePayload(byteArrayOf(120)) }
            }
            recording(server, isWanted = { it == "NT:/B" }) { running ->
                eventually("the values to be written") { running.recorder.progress.values == 3L }
                running.logs().single().entries.map { it.name }.filter { it.startsWith("NT:") } shouldBe
                    listOf("NT:/B", "NT:/FMSInfo/FMSControlData", "NT:/.schema/struct:P")
            }
            val requests = server.requests.toList().joinToString("")
            requests shouldContain """"topics":[""],"subuid":1,"options":{"periodic":0.05,"prefix":true,"topicsonly":true}"""
            requests shouldContain """"topics":["/B"]"""
            server.requests.none { "\"/A\"" in it } shouldBe true
        }
    }

    test("nothing is written until a missing server is found") {
        val tries = AtomicInteger()
        FakeServer().use { server ->
            val found = RecordedServer("robot", "NT:") { ServerAddress("127.0.0.1", server.port).takeIf { tries.incrementAndGet() > 2 } }
            recording(listOf(found), clock = server.clock) { running ->
                eventually("the connection") { running.count("connected") == 1 }
                tries.get() shouldBe 3
            }
            val never = RecordedServer("robot", "NT:") { null }
            recording(listOf(never)) { running -> running.logs().shouldBeEmpty() }
        }
    }

    test("invalid messages do not stop the recording, and are reported") {
        FakeServer().use { server ->
            server.greeting = {
                announce("/A", 1, "double")
                sendText("{")
                sendText("[".repeat(100_000))
                sendText("""[{"method":"announce","params":{"name":7}},{"method":"announce"},{"method":"later"},3,null]""")
                announce("", 2, "")
                announce("/\\u0000\\n", 3, "double[]")
                value(1, 4) { packString("x") }
                value(3, 17) { packArrayHeader(Int.MAX_VALUE) }
                for (seed in 1..300) send(kotlin.random.Random(seed).nextBytes(seed))
                send(ByteArray(0))
                number(1, 1.5)
            }
            recording(server) { running ->
                eventually("the values to be written") { running.recorder.progress.values >= 1L }
                running.count("disconnected") shouldBe 0
                running.count("The robot sent not JSON") shouldBe 1
                val log = running.logs().single()
                log.entry("NT:/A").numbers().last() shouldBe 1.5
                log.entry("messages").texts().single { "could not be read" in it } shouldMatch Regex("[1-9]\\d+ values.*")
                readRecording(running.files.single().path, LOG_FORMATS).problems.filter { it.message.contains("cut") }.shouldBeEmpty()
            }
        }
    }

    test("an endless message closes the connection, and the recorder reconnects") {
        FakeServer().use { server ->
            server.greeting = { send(ByteArray(17 shl 20)) }
            recording(server) { running ->
                eventually("the lost connection to be noticed") { running.count("disconnected") == 1 }
                running.events.first { it.startsWith("disconnected") } shouldContain "more than 16 MiB"
                server.greeting = { announce("/A", 1, "double") }
                eventually("the connection") { running.count("connected") >= 2 }
            }
        }
    }

    test("an unwritable folder stops the recorder with a sentence") {
        FakeServer().use { server ->
            val folder = kotlin.io.path.createTempDirectory("badlog")
            try {
                val file = folder.resolve("file").apply { writeText("") }
                val servers = listOf(RecordedServer("robot", "NT:") { ServerAddress("127.0.0.1", server.port) })
                Running(folder, servers, RecordOptions(file), server.clock).use { running ->
                    running.recorder.start()
                    eventually("the recorder to end") { !running.recorder.await(10) }
                    running.recorder.failure!! shouldContain "The log cannot be written"
                }
            } finally {
                folder.toFile().deleteRecursively()
            }
        }
    }
})
