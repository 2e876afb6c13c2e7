package badlog.networktables.replay

import badlog.core.waiting.eventually
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.net.Socket
import java.util.Random
import java.util.concurrent.TimeUnit

/**
 * A connection with a hand-written handshake, so that a test can send anything and read nothing. Clients of its protocol may stay silent.
 */
private fun rawClient(port: Int): Socket {
    val socket = Socket("127.0.0.1", port).apply { receiveBufferSize = 4096 }
    socket.getOutputStream().write(
        (
            "GET /nt/raw HTTP/1.1\r\nHost: a\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n" +
                "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Protocol: ${TestClient.V4_0}\r\n\r\n"
            ).toByteArray(),
    )
    return socket
}

/** A text frame, masked with zeros as a client's has to be. */
private fun textFrame(text: String): ByteArray {
    // Long enough for a length of two bytes.
    val bytes = text.padEnd(200).toByteArray()
    return byteArrayOf(0x81.toByte(), 0xfe.toByte(), (bytes.size shr 8).toByte(), bytes.size.toByte(), 0, 0, 0, 0) + bytes
}

/** Ten topics of 100,000 rows, 20 ms per row. */
private val LONG_VIEW by lazy {
    val bag = StringBuilder("Time," + (1..10).joinToString(",") { "Topic $it" } + "\n")
    for (row in 0 until 100_000) bag.append(row).append(",$row".repeat(10)).append('\n')
    viewOf(bag.toString())
}

private fun shouldStillServe(replay: TestReplay) = TestClient(replay).use { client ->
    client.subscribe("", options = TestClient.ALL_CHANGES)
    client.settle()
    client.ids().size shouldBe 8
}

@Tags("InCheck")
class BrokenClientsSpec : FunSpec({
    test("invalid messages are counted and ignored, and the client stays connected") {
        TestReplay().use { replay ->
            val server = replay.server
            TestClient(replay).use { client ->
                client.send("{")
                client.send("[".repeat(100_000))
                client.send("""[{"method":"subscribe","params":[]}]""")
                client.send(byteArrayOf(1, 2, 3))
                client.send(ByteArray(0))
                client.subscribe("/Time")
                client.settle()
                client.ids().keys shouldBe setOf("/Time")
                server.ignoredMessages shouldBe 4
                server.note shouldBe "4 messages were ignored; the first: “test client” sent not JSON."
            }
        }
    }

    test("a frame that is too long disconnects its client, not the server") {
        TestReplay().use { replay ->
            val server = replay.server
            TestClient(replay).use { client ->
                runCatching { client.send("x".repeat(2_000_000)) }
                client.closed.await(60, TimeUnit.SECONDS) shouldBe true
            }
            shouldStillServe(replay)
        }
    }

    test("garbage instead of frames or a handshake leaves the server working") {
        TestReplay().use { replay ->
            val server = replay.server
            val random = Random(5)
            repeat(100) { round ->
                val socket = if (round % 2 == 0) rawClient(server.port) else Socket("127.0.0.1", server.port)
                socket.use { runCatching { it.getOutputStream().write(ByteArray(500).also(random::nextBytes)) } }
            }
            shouldStillServe(replay)
            eventually("the clients to be ended") { server.clientNames.isEmpty() }
        }
    }

    fun handshake(vararg more: String) = "GET /nt/raw HTTP/1.1\r\nHost: a\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n" +
        "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n" + more.joinToString("") { "$it\r\n" } + "\r\n"

    /** Returns the server's answer to [request] until it ends the connection. */
    fun answerTo(server: ReplayServer, request: String): String = Socket("127.0.0.1", server.port).use { socket ->
        socket.soTimeout = 60_000
        socket.getOutputStream().write(request.toByteArray())
        socket.getInputStream().readBytes().decodeToString()
    }

    test("an endless handshake is ended and reported") {
        TestReplay().use { replay ->
            val server = replay.server
            Socket("127.0.0.1", server.port).use { socket ->
                socket.soTimeout = 60_000
                val line = "X-Line: ${"x".repeat(1000)}\r\n".toByteArray()
                runCatching {
                    socket.getOutputStream().write("GET / HTTP/1.1\r\n".toByteArray())
                    repeat(10_000) { socket.getOutputStream().write(line) }
                }
                runCatching { socket.getInputStream().readBytes() }
            }
            eventually("the report") { server.note == "A message was ignored: “somebody” sent a handshake without an end." }
            shouldStillServe(replay)
        }
    }

    test("an endless message of small pieces is ended and reported") {
        TestReplay().use { replay ->
            val server = replay.server
            rawClient(server.port).use { socket ->
                eventually("the clients") { server.clientNames == listOf("raw") }
                val begin = byteArrayOf(1, 0x80.toByte(), 0, 0, 0, 0)
                val piece = byteArrayOf(0, 0x80.toByte(), 0, 0, 0, 0)
                runCatching {
                    socket.getOutputStream().write(begin)
                    repeat(100_000) { socket.getOutputStream().write(piece) }
                }
                eventually("the clients to be ended") { server.clientNames.isEmpty() }
            }
            server.note shouldBe "A message was ignored: “raw” sent a message without an end."
            shouldStillServe(replay)
        }
    }

    test("web pages of the internet may not connect, but programs and pages of this computer may") {
        TestReplay().use { replay ->
            val server = replay.server
            val protocol = "Sec-WebSocket-Protocol: ${TestClient.V4_1}"
            for (origin in listOf("https://example.org", "http://127.0.0.1.example.org", "null", "http://")) {
                answerTo(server, handshake(protocol, "Origin: $origin")).lines()[0] shouldContain "404"
            }
            server.ignoredMessages shouldBe 4
            for (origin in listOf("file://", "http://localhost:8080", "http://127.0.0.1", "app://advantagescope")) {
                Socket("127.0.0.1", server.port).use { socket ->
                    socket.getOutputStream().write(handshake(protocol, "Origin: $origin").toByteArray())
                    socket.getInputStream().bufferedReader().readLine() shouldContain "101"
                }
            }
        }
    }

    test("at most 64 connections are kept, and the next one receives the reason") {
        TestReplay().use { replay ->
            val server = replay.server
            val others = List(64) { rawClient(server.port) }
            eventually("the clients") { server.clientNames.size == 64 }
            server.refusal shouldBe null
            TestClient(replay).use { client ->
                client.closed.await(60, TimeUnit.SECONDS) shouldBe true
                client.closingReason shouldBe "There are 64 connections already; close another dashboard first."
            }
            server.refusal shouldBe "“test client” was refused: there are 64 connections already; close another dashboard first."
            others.forEach(Socket::close)
            eventually("the clients to be ended") { server.clientNames.isEmpty() }
            shouldStillServe(replay)
        }
    }

    test("a refused connection is closed") {
        TestReplay().use { replay ->
            val server = replay.server
            answerTo(server, handshake("Sec-WebSocket-Protocol: nonsense")).lines()[0] shouldContain "404"
            answerTo(server, handshake()).isEmpty() shouldBe false
            shouldStillServe(replay)
        }
    }

    test("a client that stops reading neither delays the others nor fills the memory") {
        TestReplay(LONG_VIEW, ReplayOptions(0, speed = 20.0)).use { replay ->
            val server = replay.server
            rawClient(server.port).use { stalled ->
                stalled.getOutputStream().write(
                    textFrame("""[{"method":"subscribe","params":{"topics":[""],"subuid":1,"options":${TestClient.ALL_CHANGES}}}]"""),
                )
                // Until its subscription is answered.
                val answer = StringBuilder()
                while ("announce" !in answer) answer.append(stalled.getInputStream().read().toChar())
                TestClient(replay).use { client ->
                    client.subscribe("/Topic 3", options = """{"all":true}""")
                    client.settle()
                    server.start()
                    // Ten rows each time, more than the system buffers for a client that does not read.
                    repeat(6000) { replay.tick() }
                    eventually("all values") {
                        server.tick()
                        client.valuesOf("/Topic 3").size > 60_000
                    }
                    client.valuesOf("/Topic 3").map { it.value.asFloatValue().toDouble() } shouldBe List(60_001) { it.toDouble() }
                    server.tick() shouldBe false
                }
            }
        }
    }

    test("a client that sends requests endlessly and never reads is disconnected") {
        TestReplay().use { replay ->
            val server = replay.server
            rawClient(server.port).use { flooding ->
                eventually("the clients") { server.clientNames == listOf("raw") }
                val publish = """{"method":"publish","params":{"name":"/A","pubuid":1,"type":"int"}}"""
                val question = textFrame(List(400) { publish }.joinToString(",", "[", "]"))
                runCatching { repeat(100_000) { flooding.getOutputStream().write(question) } }
                eventually("the clients to be ended") { server.clientNames.isEmpty() }
            }
            shouldStillServe(replay)
        }
    }
})
