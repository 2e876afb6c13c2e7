package badlog.networktables.record

import badlog.networktables.SubProtocol
import org.java_websocket.WebSocket
import org.java_websocket.drafts.Draft_6455
import org.java_websocket.handshake.ClientHandshake
import org.java_websocket.protocols.Protocol
import org.java_websocket.server.WebSocketServer
import org.msgpack.core.MessageBufferPacker
import org.msgpack.core.MessagePack
import java.net.InetSocketAddress
import java.nio.ByteBuffer
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicLong

/** A clock that stands still at [micros] until a test advances it. */
internal class StillClock(micros: Long = 1_000_000) {
    private val time = AtomicLong(micros)

    val micros: Long get() = time.get()

    fun advance(micros: Long) {
        time.addAndGet(micros)
    }
}

/**
 * A NetworkTables server under the control of a test.
 *
 * @property offset its time minus the time of [clock], in µs; a test may set it.
 * @property clock the time of the computer of server and recorder.
 */
internal class FakeServer(port: Int = 0, @Volatile var offset: Long = 4_000_000, val clock: StillClock = StillClock()) :
    WebSocketServer(
        InetSocketAddress("127.0.0.1", port),
        1,
        listOf(Draft_6455(emptyList(), listOf(Protocol(SubProtocol.V4_1.id)))),
    ),
    AutoCloseable {
    private val isOpen = CountDownLatch(1)

    /** The texts that clients sent. */
    val requests = ConcurrentLinkedQueue<String>()

    /** The first messages, sent to each client that subscribes. */
    @Volatile
    var greeting: FakeServer.() -> Unit = {}

    /** The number of greeted clients. */
    val greeted = AtomicInteger()

    /** Its time now, in µs. */
    val micros: Long get() = clock.micros + offset

    init {
        isDaemon = true
        isReuseAddr = true
        start()
        check(isOpen.await(60, TimeUnit.SECONDS)) { "The server did not start." }
    }

    fun announce(name: String, id: Int, type: String, properties: String = "{}") = sendText("""[{"method":"announce","params":{"name":"$name","id":$id,"type":"$type","properties":$properties}}]""")

    fun sendText(text: String) = connections.forEach { it.send(text) }

    fun send(bytes: ByteArray) = connections.forEach { it.send(bytes) }

    /** Sends a value of topic [id]. */
    fun value(id: Int, code: Int, micros: Long = this.micros, pack: MessageBufferPacker.() -> Unit) = send(frameOf(id, code, micros, pack))

    /** Sends a value of a topic of `double`. */
    fun number(id: Int, number: Double, micros: Long = this.micros) = value(id, 1, micros) { packDouble(number) }

    /** Sends whether the robot is enabled; the topic must be announced as 99. */
    fun enable(isEnabled: Boolean) = value(99, 2) { packLong(if (isEnabled) 33 else 32) }

    fun announceControl() = announce("/FMSInfo/FMSControlData", 99, "int")

    /** Ends all connections, as a robot that is switched off. */
    fun drop() = connections.forEach { it.closeConnection(1001, "") }

    override fun onStart() = isOpen.countDown()

    override fun onOpen(socket: WebSocket, request: ClientHandshake) = Unit

    override fun onMessage(socket: WebSocket, text: String) {
        val isFirst = "\"\"" in text
        requests += text
        if (!isFirst) return
        greeting()
        greeted.incrementAndGet()
    }

    override fun onMessage(socket: WebSocket, binary: ByteBuffer) {
        val unpacker = MessagePack.newDefaultUnpacker(binary)
        check(unpacker.unpackArrayHeader() == 4 && unpacker.unpackInt() == -1) { "Only the time may be sent." }
        unpacker.skipValue(2)
        val sent = unpacker.unpackLong()
        socket.send(frameOf(-1, 2, micros) { packLong(sent) })
    }

    override fun onClose(socket: WebSocket, code: Int, reason: String?, isRemote: Boolean) = Unit

    override fun onError(socket: WebSocket?, error: Exception) = Unit

    override fun close() = stop(1000)
}

/** A frame with one value. */
internal fun frameOf(id: Int, code: Int, micros: Long, pack: MessageBufferPacker.() -> Unit): ByteArray = MessagePack.newDefaultBufferPacker().run {
    packArrayHeader(4).packInt(id).packLong(micros).packInt(code)
    pack()
    toByteArray()
}
