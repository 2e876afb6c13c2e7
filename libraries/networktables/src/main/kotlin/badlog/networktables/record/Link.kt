package badlog.networktables.record

import badlog.networktables.SubProtocol
import java.io.ByteArrayOutputStream
import java.net.URI
import java.net.http.HttpClient
import java.net.http.WebSocket
import java.nio.ByteBuffer
import java.time.Duration
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionStage
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException
import java.util.concurrent.atomic.AtomicBoolean

/**
 * A connection to the server [source] at [address]. Everything received goes into [inbox].
 *
 * @param clock returns this computer's time in µs, from an arbitrary origin.
 */
internal class Link(val source: Source, val address: ServerAddress, private val inbox: Inbox, private val clock: () -> Long) :
    WebSocket.Listener {
    private val text = StringBuilder()
    private val binary = ByteArrayOutputStream()
    private val isOver = AtomicBoolean()
    private var sending: CompletableFuture<*> = CompletableFuture.completedFuture(null)

    @Volatile
    private var socket: WebSocket? = null

    /** The arrival time of the last message. */
    @Volatile
    var receivedMicros: Long = clock()
        private set

    val isClosed: Boolean get() = isOver.get()

    /** Connects. Returns false if the server does not answer, or is not one of NetworkTables 4. */
    fun open(client: HttpClient): Boolean {
        val opening = client.newWebSocketBuilder()
            .connectTimeout(Duration.ofSeconds(CONNECT_SECONDS))
            .subprotocols(SubProtocol.V4_1.id, SubProtocol.V4_0.id)
            .buildAsync(URI("ws://$address/nt/badlog-record"), this)
        return try {
            opening.get(CONNECT_SECONDS + 1, TimeUnit.SECONDS)
            true
        } catch (_: ExecutionException) {
            false
        } catch (_: TimeoutException) {
            // It may still open later, when it is no longer needed.
            opening.thenAccept(WebSocket::abort)
            false
        }
    }

    /** Requests the server's time. The answer also shows that the server is alive. */
    fun askTime(): Unit = send { it.sendBinary(timeRequest(clock()), true) }

    fun send(text: String): Unit = send { it.sendText(text, true) }

    /** Ends the connection immediately because of [reason], part of a sentence. */
    fun close(reason: String) {
        if (isOver.compareAndSet(false, true)) inbox.add(Incoming.Closed(this, reason, receivedMicros))
        socket?.abort()
    }

    /** Ends the connection immediately without reporting it, because it is no longer needed. */
    fun end() {
        isOver.set(true)
        socket?.abort()
    }

    // A message may only be sent after the previous one.
    @Synchronized
    private fun send(message: (WebSocket) -> CompletableFuture<WebSocket>) {
        val socket = socket ?: return
        sending = sending.handle { _, _ -> }.thenCompose { message(socket) }
    }

    override fun onOpen(socket: WebSocket) {
        this.socket = socket
        receivedMicros = clock()
        inbox.add(Incoming.Opened(this))
        socket.request(1)
    }

    override fun onText(socket: WebSocket, part: CharSequence, isLast: Boolean): CompletionStage<*>? {
        text.append(part)
        if (text.length > MAX_MESSAGE) return endless()
        if (isLast) {
            if (!inbox.add(Incoming.Text(this, text.toString()))) close("it announces more than can be written")
            text.setLength(0)
        }
        return next(socket)
    }

    override fun onBinary(socket: WebSocket, bytes: ByteBuffer, isLast: Boolean): CompletionStage<*>? {
        binary.write(ByteArray(bytes.remaining()).also(bytes::get))
        if (binary.size() > MAX_MESSAGE) return endless()
        if (isLast) {
            inbox.add(Incoming.Values(this, binary.toByteArray(), clock()))
            binary.reset()
        }
        return next(socket)
    }

    override fun onPing(socket: WebSocket, message: ByteBuffer): CompletionStage<*>? = next(socket)

    override fun onPong(socket: WebSocket, message: ByteBuffer): CompletionStage<*>? = next(socket)

    override fun onClose(socket: WebSocket, code: Int, reason: String): CompletionStage<*>? = null.also {
        close(if (reason.isBlank()) "the server closed it" else "the server closed it, saying “${reason.take(MAX_REASON)}”")
    }

    override fun onError(socket: WebSocket, error: Throwable) = close("the network failed")

    private fun next(socket: WebSocket): CompletionStage<*>? {
        receivedMicros = clock()
        socket.request(1)
        return null
    }

    private fun endless(): CompletionStage<*>? = null.also { close("the server sent a message of more than 16 MiB") }
}

private const val CONNECT_SECONDS = 2L

/** The maximum length of a message, in bytes or characters. */
private const val MAX_MESSAGE = 16 shl 20
private const val MAX_REASON = 100
