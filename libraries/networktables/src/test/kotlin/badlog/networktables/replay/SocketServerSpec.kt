package badlog.networktables.replay

import badlog.core.waiting.eventually
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import org.java_websocket.WebSocketImpl
import java.net.InetSocketAddress
import java.net.URI
import java.net.http.HttpClient
import java.net.http.WebSocket
import java.nio.ByteBuffer
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionStage
import java.util.concurrent.TimeUnit

@Tags("InCheck")
class SocketServerSpec : FunSpec({
    test("a frame that the library forgot to write is written when its queue is looked at") {
        val server = SocketServer(InetSocketAddress("127.0.0.1", 0), { 0 }, Deaf, IgnoredMessages())
        server.open()
        val received = CompletableFuture<String>()
        val client = object : WebSocket.Listener {
            override fun onText(socket: WebSocket, part: CharSequence, isLast: Boolean): CompletionStage<*>? = null.also { received.complete("$part") }
        }
        val socket = HttpClient.newHttpClient().newWebSocketBuilder().subprotocols(TestClient.V4_1)
            .buildAsync(URI("ws://127.0.0.1:${server.port}/nt/test"), client).get(60, TimeUnit.SECONDS)
        eventually("the server to know its client") { server.connections.size == 1 }
        val connection = server.connections.single() as WebSocketImpl
        eventually("the handshake to be written") { connection.outQueue.isEmpty() }

        // As if the thread that writes had cleared this frame's demand.
        connection.outQueue.add(ByteBuffer.wrap(byteArrayOf(TEXT_FRAME, 2, 'h'.code.toByte(), 'i'.code.toByte())))
        server.writeQueued()
        received.get(60, TimeUnit.SECONDS) shouldBe "hi"
        socket.abort()
        server.stop()
    }
})

private const val TEXT_FRAME = 0x81.toByte()

private object Deaf : Listener {
    override fun opened(connection: Connection) = Unit

    override fun received(connection: Connection, text: String) = Unit

    override fun closed(connection: Connection) = Unit
}
