package badlog.networktables.replay

import badlog.networktables.SubProtocol
import org.java_websocket.WebSocket
import org.java_websocket.WebSocketImpl
import org.java_websocket.framing.CloseFrame
import org.java_websocket.framing.Framedata
import org.java_websocket.handshake.ClientHandshake
import org.java_websocket.server.WebSocketServer
import org.msgpack.core.MessagePackException
import java.io.IOException
import java.net.BindException
import java.net.InetSocketAddress
import java.nio.ByteBuffer
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/**
 * Manages the connections, and answers requests for the time immediately on the thread that reads them.
 *
 * @param micros returns the server's time in µs.
 */
internal class SocketServer(
    address: InetSocketAddress,
    private val micros: () -> Long,
    private val listener: Listener,
    private val ignored: IgnoredMessages,
) : WebSocketServer(address, 1, listOf(BoundedDraft(address.address.hostAddress, ignored::add), AliveAnswer())) {
    private val binding = CompletableFuture<Unit>()

    init {
        isDaemon = true
        isReuseAddr = true
        isTcpNoDelay = true
        // A 4.0 client must not be pinged, so pinging is left to code that knows the versions.
        connectionLostTimeout = 0
    }

    /** Opens the port. Throws [UnavailablePortException] if it is unavailable. */
    fun open() {
        start()
        try {
            binding.get(BINDING_SECONDS, TimeUnit.SECONDS)
        } catch (e: ExecutionException) {
            stop()
            throw UnavailablePortException(address, e.cause as Exception)
        } catch (_: TimeoutException) {
            stop()
            throw UnavailablePortException(address, IOException("the computer did not open it within a minute"))
        }
    }

    override fun onStart() {
        binding.complete(Unit)
    }

    override fun onOpen(socket: WebSocket, request: ClientHandshake) {
        val protocol = SubProtocol.entries.find { it.id == socket.protocol?.providedProtocol }
        if (socket.draft is AliveAnswer || protocol == null) return socket.close()
        val connection = Connection(socket, protocol, request.resourceDescriptor, micros())
        if (connections.size > MAX_CONNECTIONS) {
            ignored.refuse(connection.name, MAX_CONNECTIONS)
            val reason = "There are $MAX_CONNECTIONS connections already; close another dashboard first."
            return socket.close(CloseFrame.TRY_AGAIN_LATER, reason)
        }
        socket.setAttachment(connection)
        listener.opened(connection)
        // Another thread may have closed it before it was registered here, and that is not reported again.
        if (!(socket as WebSocketImpl).channel.isOpen) listener.closed(connection)
    }

    override fun onMessage(socket: WebSocket, text: String) {
        val connection = connectionOf(socket) ?: return
        if (connection.protocol == SubProtocol.TIME_ONLY) return ignored.add(connection.name, "text where only the time is sent")
        listener.received(connection, text)
        endIfFlooded(socket, connection)
    }

    override fun onMessage(socket: WebSocket, binary: ByteBuffer) {
        val connection = connectionOf(socket) ?: return
        try {
            answerTime(binary, micros())?.let(connection::send)
        } catch (_: MessagePackException) {
            ignored.add(connection.name, "values that are not MessagePack")
        } catch (_: IOException) {
            ignored.add(connection.name, "incomplete values")
        }
        endIfFlooded(socket, connection)
    }

    override fun onWebsocketPing(socket: WebSocket, frame: Framedata) {
        super.onWebsocketPing(socket, frame)
        connectionOf(socket)?.let { endIfFlooded(socket, it) }
    }

    /** Closes a connection with a refused handshake. The library would leave it open, waiting for it to read data that was never sent. */
    override fun onClosing(socket: WebSocket, code: Int, reason: String?, isRemote: Boolean) {
        val refused = socket as WebSocketImpl
        if (refused.draft != null) return
        try {
            generateSequence { refused.outQueue.poll() }.forEach { refused.channel.write(it) }
        } catch (_: IOException) {
            // It has already been closed.
        }
        refused.closeConnection(code, reason.orEmpty())
    }

    override fun onWebsocketPong(socket: WebSocket, frame: Framedata) {
        connectionOf(socket)
    }

    override fun onClose(socket: WebSocket, code: Int, reason: String?, isRemote: Boolean) {
        socket.getAttachment<Connection?>()?.let(listener::closed)
    }

    override fun onError(socket: WebSocket?, error: Exception) {
        if (socket == null) binding.completeExceptionally(error)
    }

    /**
     * Asks the library again to write the data that is still queued. It forgets a frame that is queued while its thread finishes writing
     * the previous one, until the next frame follows.
     */
    fun writeQueued() {
        for (socket in connections) if (socket.hasBufferedData()) onWriteDemand(socket)
    }

    private fun connectionOf(socket: WebSocket): Connection? = socket.getAttachment<Connection?>()?.also { it.receivedMicros = micros() }

    /** Ends a client that sends requests without reading the answers, which would fill the memory. */
    private fun endIfFlooded(socket: WebSocket, connection: Connection) {
        if ((socket as WebSocketImpl).outQueue.size > MAX_FRAMES) connection.end("It does not read its messages.")
    }
}

/** Receives events of a [SocketServer]'s connections; for one connection, never concurrently. */
internal interface Listener {
    fun opened(connection: Connection)

    fun received(connection: Connection, text: String)

    fun closed(connection: Connection)
}

/** Thrown if the port of a replay cannot be opened. The message is one sentence that says why and what to do. */
class UnavailablePortException internal constructor(address: InetSocketAddress, cause: Exception) :
    IOException(
        if (cause is BindException && "in use" in cause.message.orEmpty()) {
            "Port ${address.port} is in use, perhaps by a robot simulation or another replay; " +
                "end that program, or use another port."
        } else {
            "Port ${address.port} of ${address.address.hostAddress} cannot be opened (${cause.message}); use another port."
        },
        cause,
    )

private const val BINDING_SECONDS = 60L
private const val MAX_FRAMES = 4_000

/** The maximum number of connections. Usually one or two dashboards are connected. */
private const val MAX_CONNECTIONS = 64
