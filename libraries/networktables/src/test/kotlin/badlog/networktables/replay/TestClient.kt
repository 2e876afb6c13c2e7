package badlog.networktables.replay

import badlog.core.waiting.eventually
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.msgpack.core.MessagePack
import org.msgpack.value.Value
import java.io.ByteArrayOutputStream
import java.net.URI
import java.net.http.HttpClient
import java.net.http.WebSocket
import java.nio.ByteBuffer
import java.util.concurrent.CompletionStage
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/** A received value: the topic's number, microseconds, type and value. */
internal class Received(val id: Int, val micros: Long, val type: Int, val value: Value)

/** An NT4 client on the JDK's WebSocket, independent of the server's code. */
internal class TestClient(private val replay: TestReplay, vararg protocols: String = arrayOf(V4_1)) : WebSocket.Listener, AutoCloseable {
    val messages = ArrayList<JsonObject>()
    val values = ArrayList<Received>()
    val closed = CountDownLatch(1)

    @Volatile
    var closingReason = ""
    private val text = StringBuilder()
    private val binary = ByteArrayOutputStream()
    private val socket: WebSocket = HttpClient.newHttpClient().newWebSocketBuilder()
        .subprotocols(protocols.first(), *protocols.drop(1).toTypedArray())
        .buildAsync(URI("ws://127.0.0.1:${replay.server.port}/nt/test%20client"), this).get(60, TimeUnit.SECONDS)

    val protocol: String get() = socket.subprotocol

    override fun onText(socket: WebSocket, part: CharSequence, isLast: Boolean): CompletionStage<*>? {
        text.append(part)
        if (isLast) {
            val frame = Json.parseToJsonElement(text.toString()).jsonArray
            synchronized(this) { messages += frame.map { it.jsonObject } }
            text.clear()
        }
        socket.request(1)
        return null
    }

    override fun onBinary(socket: WebSocket, bytes: ByteBuffer, isLast: Boolean): CompletionStage<*>? {
        binary.write(ByteArray(bytes.remaining()).also(bytes::get))
        if (isLast) receive(binary.toByteArray()).also { binary.reset() }
        socket.request(1)
        return null
    }

    private fun receive(frame: ByteArray) {
        val unpacker = MessagePack.newDefaultUnpacker(frame)
        synchronized(this) {
            while (unpacker.hasNext()) {
                check(unpacker.unpackArrayHeader() == 4)
                values += Received(unpacker.unpackInt(), unpacker.unpackLong(), unpacker.unpackInt(), unpacker.unpackValue())
            }
        }
    }

    override fun onClose(socket: WebSocket, code: Int, reason: String): CompletionStage<*>? = null.also {
        closingReason = reason
        closed.countDown()
    }

    override fun onError(socket: WebSocket, error: Throwable) = closed.countDown()

    fun send(json: String) {
        socket.sendText(json, true).get(60, TimeUnit.SECONDS)
    }

    fun send(bytes: ByteArray) {
        socket.sendBinary(ByteBuffer.wrap(bytes), true).get(60, TimeUnit.SECONDS)
    }

    fun subscribe(vararg topics: String, options: String = "{}", id: Int = 1) = send(
        """[{"method":"subscribe","params":{"topics":[${topics.joinToString { "\"$it\"" }}],"subuid":$id,"options":$options}}]""",
    )

    /** Waits until the server has answered everything sent so far. All earlier messages of the server have then arrived, too. */
    fun roundTrip() {
        val before = count { it.id == -1 }
        send(byteArrayOf(0x94.toByte(), -1, 0, 2, 7))
        eventually("the server to answer") {
            replay.server.writeQueued()
            count { it.id == -1 } > before
        }
    }

    /** Waits until all answers to the messages sent so far have arrived. */
    fun settle() {
        roundTrip()
        replay.sendDue()
        roundTrip()
    }

    fun params(method: String): List<JsonObject> = synchronized(this) {
        messages.filter { it.getValue("method").jsonPrimitive.content == method }.map { it.getValue("params").jsonObject }
    }

    /** The numbers of the announced topics, by their names. */
    fun ids(): Map<String, Int> = params("announce").associate { it.getValue("name").jsonPrimitive.content to it.getValue("id").jsonPrimitive.content.toInt() }

    fun valuesOf(name: String): List<Received> {
        val id = ids()[name]
        return synchronized(this) { values.filter { it.id == id } }
    }

    fun count(predicate: (Received) -> Boolean): Int = synchronized(this) { values.count(predicate) }

    override fun close() = socket.abort()

    companion object {
        const val V4_1 = "v4.1.networktables.first.wpi.edu"
        const val V4_0 = "networktables.first.wpi.edu"
        const val TIME_ONLY = "rtt.networktables.first.wpi.edu"
        const val ALL_CHANGES = """{"prefix":true,"all":true}"""
    }
}
