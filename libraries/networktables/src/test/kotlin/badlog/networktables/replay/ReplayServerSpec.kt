package badlog.networktables.replay

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonPrimitive
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse
import java.net.http.WebSocketHandshakeException
import java.util.concurrent.ExecutionException

private fun serving(
    speed: Double = 1.0,
    isLooping: Boolean = false,
    range: ClosedFloatingPointRange<Double>? = null,
    prefix: String = "",
    action: (TestReplay) -> Unit,
) = TestReplay(options = ReplayOptions(0, speed = speed, isLooping = isLooping, range = range, prefix = prefix)).use(action)

@Tags("InCheck")
class ReplayServerSpec : FunSpec({
    test("a client that subscribes to everything receives every topic with type, unit and current value") {
        serving { replay ->
            TestClient(replay).use { client ->
                client.subscribe("", options = TestClient.ALL_CHANGES)
                client.settle()
                val angle = client.params("announce").single { it["name"]!!.jsonPrimitive.content == "/Arm/Angle" }
                angle["type"] shouldBe Json.parseToJsonElement("\"double\"")
                angle["properties"] shouldBe Json.parseToJsonElement("""{"unit":"deg","retained":true}""")
                client.ids().keys shouldBe setOf(
                    "/Time",
                    "/Arm/Angle",
                    "/Arm/At Top",
                    "/Arm/State",
                    "/Log",
                    "/Nothing",
                    "/Values/Match Number",
                    "/Values/Arm/Größe",
                )
                client.settle()
                client.valuesOf("/Arm/Angle").single().value.asFloatValue().toDouble() shouldBe 1.5
                client.valuesOf("/Arm/State").single().value.asStringValue().asString() shouldBe "idle"
                client.valuesOf("/Values/Match Number").single().value.asStringValue().asString() shouldBe "8"
                client.valuesOf("/Log").shouldBeEmpty()
                replay.server.clientNames shouldBe listOf("test client")
            }
        }
    }

    test("every sample arrives once, in order and at its time") {
        for (speed in listOf(1.0, 0.5, 4.0)) {
            serving(speed) { replay ->
                TestClient(replay).use { client ->
                    client.subscribe("", options = TestClient.ALL_CHANGES)
                    client.settle()
                    replay.playToEnd()
                    client.settle()
                    client.valuesOf("/Time").map { it.value.asFloatValue().toDouble() } shouldBe listOf(10.0, 10.02, 10.05, 10.06, 10.1, 10.3)
                    client.valuesOf("/Arm/At Top").map { it.value.asBooleanValue().boolean } shouldBe
                        listOf(false, false, true, true, true, false)
                    client.valuesOf("/Log").map { it.value.asStringValue().asString() } shouldBe listOf("up we go", "again “up”", "done")
                    val times = client.valuesOf("/Time")
                    for (time in times.drop(1)) {
                        val passed = (time.micros - times[1].micros) * 1e-6 * speed
                        passed shouldBe ((time.value.asFloatValue().toDouble() - 10.02) plusOrMinus 2e-6 * maxOf(1.0, speed))
                    }
                    val all = client.values.filter { it.id >= 0 && it.micros > times[0].micros }
                    all.map { it.micros } shouldBe all.map { it.micros }.sorted()
                }
            }
        }
    }

    test("samples played since the last tick arrive with the next one, and none before its time") {
        serving { replay ->
            TestClient(replay).use { client ->
                client.subscribe("/Time", options = """{"all":true}""")
                client.settle()
                replay.server.start()
                while (!replay.server.isAtEnd) {
                    replay.advance()
                    client.roundTrip()
                    client.valuesOf("/Time").size shouldBe listOf(10.0, 10.02, 10.05, 10.06, 10.1, 10.3).count { it <= replay.server.position }
                }
            }
        }
    }

    test("subscriptions select whole names, prefixes if requested, and topics without values if requested") {
        serving { replay ->
            TestClient(replay).use { client ->
                client.subscribe("/Arm", "/Arm/State", id = 1)
                client.settle()
                client.valuesOf("/Arm/State").size shouldBe 1
                client.ids().keys shouldBe setOf("/Arm/State")
                client.subscribe("/Arm/A", options = """{"prefix":true,"topicsonly":true}""", id = 2)
                client.settle()
                client.ids().keys shouldBe setOf("/Arm/State", "/Arm/Angle", "/Arm/At Top")
                client.valuesOf("/Arm/Angle").shouldBeEmpty()
                client.subscribe("$", options = """{"prefix":true}""", id = 3)
                client.send("""[{"method":"unsubscribe","params":{"subuid":1}}]""")
                client.settle()
                replay.playToEnd()
                client.settle()
                client.valuesOf("/Arm/State").size shouldBe 1
                client.valuesOf("/Arm/Angle").shouldBeEmpty()
            }
        }
    }

    test("with a period the latest value arrives at most that often, and the last one always arrives") {
        serving { replay ->
            TestClient(replay).use { client ->
                client.subscribe("/Arm/Angle", options = """{"periodic":0.15}""")
                client.settle()
                client.valuesOf("/Arm/Angle").size shouldBe 1
                replay.server.start()
                replay.advance(45)
                client.roundTrip()
                client.valuesOf("/Arm/Angle").map { it.value.asFloatValue().toDouble() } shouldBe listOf(1.5, 2.5, 4.0)
            }
        }
    }

    test("a loop repeats the range, and all names have the prefix") {
        serving(isLooping = true, range = 10.05..10.1, prefix = "/badlog") { replay ->
            TestClient(replay).use { client ->
                client.subscribe("/badlog/Time")
                client.subscribe("/badlog/Log", options = """{"all":true}""", id = 2)
                client.settle()
                replay.server.start()
                // Each of four laps begins with the values at its start.
                replay.advance(19)
                client.roundTrip()
                client.valuesOf("/badlog/Log").map { it.value.asStringValue().asString() } shouldBe List(8) { if (it % 2 == 0) "up we go" else "again “up”" }
                replay.server.isAtEnd shouldBe false
            }
        }
    }

    test("a jump sends the values there, a pause keeps them, and starting at the end replays from the start") {
        serving { replay ->
            val server = replay.server
            TestClient(replay).use { client ->
                fun angles() = client.valuesOf("/Arm/Angle").map { it.value.asFloatValue().toDouble() }
                client.subscribe("/Arm/Angle", options = """{"all":true}""")
                client.settle()
                angles() shouldBe listOf(1.5)
                server.seek(10.03)
                server.position shouldBe 10.03
                client.settle()
                angles() shouldBe listOf(1.5, 2.5)
                server.seek(99.0)
                server.isAtEnd shouldBe true
                server.start()
                server.isAtEnd shouldBe false
                replay.advance()
                server.pause()
                val position = server.position
                replay.advance(6)
                server.position shouldBe position
                server.speed = 2.0
                server.speed shouldBe 2.0
                shouldThrow<IllegalArgumentException> { server.speed = -1.0 }
            }
        }
    }

    test("a publishing client is answered, and the recording stays unchanged") {
        serving { replay ->
            TestClient(replay).use { client ->
                client.send(
                    """[{"method":"publish","params":{"name":"/Mine","pubuid":5,"type":"int","properties":{"a":1}}},
                    {"method":"publish","params":{"name":"/Arm/Angle","pubuid":6,"type":"string","properties":{}}},
                    {"method":"setproperties","params":{"name":"/Mine","update":{"a":2}}},
                    {"method":"setproperties","params":{"name":"/Arm/Angle","update":{"unit":"rad"}}}]""",
                )
                client.send(byteArrayOf(0x94.toByte(), 6, 0, 4, 0xa1.toByte(), 65))
                client.settle()
                val (mine, angle) = client.params("announce")
                mine["pubuid"].toString() shouldBe "5"
                mine["type"].toString() shouldBe "\"int\""
                angle["pubuid"].toString() shouldBe "6"
                angle["type"].toString() shouldBe "\"double\""
                client.params("properties").single().toString() shouldBe """{"name":"/Mine","ack":true,"update":{"a":2}}"""
                client.send("""[{"method":"unpublish","params":{"pubuid":5}},{"method":"unpublish","params":{"pubuid":6}}]""")
                client.settle()
                client.params("unannounce").single()["id"] shouldBe mine["id"]
                TestClient(replay).use { other ->
                    other.subscribe("/", options = TestClient.ALL_CHANGES)
                    other.settle()
                    other.valuesOf("/Arm/Angle").single().value.asFloatValue().toDouble() shouldBe 1.5
                    ("/Mine" in other.ids()) shouldBe false
                }
                replay.server.note shouldBe null
            }
        }
    }

    test("the best subprotocol is chosen, the one for the time only answers that, and unknown ones are refused") {
        serving { replay ->
            TestClient(replay, TestClient.V4_0, TestClient.V4_1).use { it.protocol shouldBe TestClient.V4_1 }
            TestClient(replay, TestClient.V4_0).use { it.protocol shouldBe TestClient.V4_0 }
            TestClient(replay, TestClient.TIME_ONLY).use { client ->
                client.subscribe("", options = TestClient.ALL_CHANGES)
                client.settle()
                client.messages.shouldBeEmpty()
                client.values.map { it.id to it.micros } shouldBe List(2) { -1 to 1_000_000L }
                ("test client" in replay.server.clientNames) shouldBe false
            }
            val refused = shouldThrow<ExecutionException> { TestClient(replay, "soap") }
            (refused.cause is WebSocketHandshakeException) shouldBe true
        }
    }

    test("a plain HTTP request is answered") {
        serving { replay ->
            val request = HttpRequest.newBuilder(URI("http://127.0.0.1:${replay.server.port}")).build()
            val answer = HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofString())
            answer.statusCode() shouldBe 200
            answer.body() shouldContain "NetworkTables 4"
            answer.headers().firstValue("Access-Control-Allow-Origin").get() shouldBe "*"
        }
    }

    test("a port in use is reported with the next step, and a port is free after closing") {
        val port = ReplayServer(VARIED_VIEW, ReplayOptions(0)).use { server ->
            server.start()
            ReplayServer(VARIED_VIEW, ReplayOptions(server.port)).use { second ->
                shouldThrow<UnavailablePortException> { second.open() }.message shouldBe "Port ${server.port} is taken, " +
                    "by a robot simulation or another replay perhaps: end that program, or use another port."
            }
            server.port
        }
        ReplayServer(VARIED_VIEW, ReplayOptions(port)).use {
            it.open()
            it.open()
            it.close()
            it.close()
            shouldThrow<IllegalStateException> { it.start() }
        }
    }

    test("options out of range are refused") {
        shouldThrow<IllegalArgumentException> { ReplayOptions(port = 70_000) }
        shouldThrow<IllegalArgumentException> { ReplayOptions(speed = Double.NaN) }
        shouldThrow<IllegalArgumentException> { ReplayOptions(range = 2.0..1.0) }
        ReplayOptions().address.isLoopbackAddress shouldBe true
    }

    test("logged topics arrive with their own types, beside calculated ones") {
        val poses = LoggedTopic("NT:/Pose", "struct:Pose2d", "", doubleArrayOf(10.0, 10.1)) { byteArrayOf(it.toByte(), 7) }
        val schema = LoggedTopic("NT:/.schema/struct:Pose2d", "structschema", "", doubleArrayOf(10.0)) { "double x".encodeToByteArray() }
        TestReplay(options = ReplayOptions(0, prefix = "old"), logged = listOf(poses, schema)).use { replay ->
            TestClient(replay).use { client ->
                client.subscribe("", options = TestClient.ALL_CHANGES)
                client.settle()
                val types = client.params("announce").associate { it["name"]!!.jsonPrimitive.content to it["type"]!!.jsonPrimitive.content }
                types["/old/Pose"] shouldBe "struct:Pose2d"
                types["/.schema/struct:Pose2d"] shouldBe "structschema"
                types["/old/Arm/Angle"] shouldBe "double"
                client.settle()
                client.valuesOf("/.schema/struct:Pose2d").single().value.asBinaryValue().asByteArray().decodeToString() shouldBe "double x"
                client.valuesOf("/old/Pose").size shouldBe 1
                replay.playToEnd()
                client.roundTrip()
                client.valuesOf("/old/Pose").map { it.value.asBinaryValue().asByteArray().toList() } shouldBe
                    listOf(listOf<Byte>(0, 7), listOf<Byte>(1, 7))
            }
        }
    }
})
