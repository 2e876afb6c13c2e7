package badlog.replay

import org.java_websocket.WebSocket
import org.java_websocket.exceptions.WebsocketNotConnectedException
import java.net.URLDecoder
import java.nio.ByteBuffer

/**
 * A client's WebSocket.
 *
 * @property name what the client calls itself.
 */
internal class Connection(private val socket: WebSocket, val protocol: SubProtocol, path: String) : Wire {
    val name: String = nameIn(path)

    /** When the client was last heard of. */
    @Volatile
    var heardNanos: Long = System.nanoTime()

    override val isBusy: Boolean get() = socket.hasBufferedData()

    override fun send(text: String) = whileOpen { socket.send(text) }

    override fun send(binary: ByteBuffer) = whileOpen { socket.send(binary) }

    fun ping() = whileOpen { socket.sendPing() }

    /** Ends it at once, whatever is still to be sent. */
    fun end(why: String) = socket.closeConnection(GOING_AWAY, why)

    // It may be closed at any moment; whoever has to know is told of that elsewhere.
    private fun whileOpen(send: () -> Unit) = try {
        send()
    } catch (_: WebsocketNotConnectedException) {
        Unit
    }

    private companion object {
        const val GOING_AWAY = 1001
        const val LONGEST_NAME = 100

        fun nameIn(path: String): String {
            val name = path.substringBefore('?').removePrefix("/nt/")
            val readable = try {
                URLDecoder.decode(name.replace("+", "%2B"), Charsets.UTF_8)
            } catch (_: IllegalArgumentException) {
                name
            }
            return readable.filterNot { it.isISOControl() }.take(LONGEST_NAME)
        }
    }
}
