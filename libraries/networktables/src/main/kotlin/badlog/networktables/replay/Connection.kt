package badlog.networktables.replay

import badlog.networktables.SubProtocol
import org.java_websocket.WebSocket
import org.java_websocket.exceptions.WebsocketNotConnectedException
import java.net.URLDecoder
import java.nio.ByteBuffer

/**
 * A client's WebSocket.
 *
 * @property name the client's own name.
 * @property receivedMicros the arrival time of the client's last message.
 */
internal class Connection(private val socket: WebSocket, val protocol: SubProtocol, path: String, @Volatile var receivedMicros: Long) :
    Wire {
    val name: String = nameIn(path)

    override val isBusy: Boolean get() = socket.hasBufferedData()

    override fun send(text: String) = whileOpen { socket.send(text) }

    override fun send(binary: ByteBuffer) = whileOpen { socket.send(binary) }

    fun ping() = whileOpen { socket.sendPing() }

    /** Ends the connection immediately, even with queued data. */
    fun end(why: String) = socket.closeConnection(GOING_AWAY, why)

    // It may be closed at any moment; that is reported elsewhere.
    private fun whileOpen(send: () -> Unit) = try {
        send()
    } catch (_: WebsocketNotConnectedException) {
        Unit
    }

    private companion object {
        const val GOING_AWAY = 1001
        const val MAX_NAME = 100

        fun nameIn(path: String): String {
            val name = path.substringBefore('?').removePrefix("/nt/")
            val readable = try {
                URLDecoder.decode(name.replace("+", "%2B"), Charsets.UTF_8)
            } catch (_: IllegalArgumentException) {
                name
            }
            return readable.filterNot { it.isISOControl() }.take(MAX_NAME)
        }
    }
}

/** The connection to one client. Nothing here blocks: data that cannot be sent at once is queued. */
internal interface Wire {
    /** Whether data is still queued, because the client reads too slowly. */
    val isBusy: Boolean

    fun send(text: String)

    fun send(binary: ByteBuffer)
}
