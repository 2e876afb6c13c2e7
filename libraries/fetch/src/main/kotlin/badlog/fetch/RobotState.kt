package badlog.fetch

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.io.ByteArrayOutputStream
import java.net.URI
import java.net.http.HttpClient
import java.net.http.WebSocket
import java.nio.BufferUnderflowException
import java.nio.ByteBuffer
import java.time.Duration
import java.util.concurrent.CompletionStage
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Knows whether the robot at [address] is enabled, from `FMSControlData` of its NetworkTables server. Must be
 * closed.
 *
 * @param patience how long to wait for it.
 * @throws UnknownStateException if the robot does not report it.
 */
internal class RobotState(private val address: RobotAddress, private val patience: Duration) : AutoCloseable {
    private val lock = ReentrantLock()
    private val change = lock.newCondition()
    private var control: Long? = null
    private var isLost = false
    private val socket = connect()

    init {
        val json = """[{"method":"subscribe","params":{"topics":["$TOPIC"],"subuid":1,"options":{}}}]"""
        socket.sendText(json, true)
        var left = patience.toNanos()
        lock.withLock {
            while (control == null && !isLost && left > 0) left = change.awaitNanos(left)
            if (control == null) {
                socket.abort()
                throw UnknownStateException(address, "its NetworkTables have no $TOPIC")
            }
        }
    }

    /**
     * Whether it is currently enabled.
     *
     * @throws UnknownStateException if the connection was lost.
     */
    val isEnabled: Boolean get() = lock.withLock {
        if (isLost) throw UnknownStateException(address, "its NetworkTables no longer answer")
        control!! and ENABLED != 0L
    }

    /** Waits until it is disabled. Throws the same exceptions as [isEnabled]. */
    fun awaitDisabled() = lock.withLock {
        while (isEnabled) change.await()
    }

    override fun close() = socket.abort()

    private fun connect(): WebSocket = try {
        HttpClient.newBuilder().connectTimeout(patience).build().newWebSocketBuilder()
            .connectTimeout(patience)
            .subprotocols("v4.1.networktables.first.wpi.edu", "networktables.first.wpi.edu")
            .buildAsync(URI("ws://${address.host}:${address.networkTablesPort}/nt/badlog-fetch"), Messages())
            .get(patience.toMillis(), TimeUnit.MILLISECONDS)
    } catch (_: ExecutionException) {
        throw UnknownStateException(address, "its NetworkTables do not answer")
    } catch (_: TimeoutException) {
        throw UnknownStateException(address, "its NetworkTables do not answer")
    }

    private inner class Messages : WebSocket.Listener {
        private val text = StringBuilder()
        private val binary = ByteArrayOutputStream()
        private var topic: Long? = null

        override fun onText(socket: WebSocket, part: CharSequence, isLast: Boolean): CompletionStage<*>? {
            text.append(part)
            if (isLast) {
                announcement(text.toString())?.let { topic = it }
                text.clear()
            } else if (text.length > MAX_MESSAGE) {
                lose()
            }
            socket.request(1)
            return null
        }

        override fun onBinary(socket: WebSocket, bytes: ByteBuffer, isLast: Boolean): CompletionStage<*>? {
            binary.write(ByteArray(bytes.remaining()).also(bytes::get))
            if (isLast) {
                controlIn(ByteBuffer.wrap(binary.toByteArray()))
                binary.reset()
            } else if (binary.size() > MAX_MESSAGE) {
                lose()
            }
            socket.request(1)
            return null
        }

        override fun onClose(socket: WebSocket, code: Int, reason: String): CompletionStage<*>? = null.also { lose() }

        override fun onError(socket: WebSocket, error: Throwable) = lose()

        /** Returns the id that the server assigns to the topic in [frame], if it does. */
        private fun announcement(frame: String): Long? = try {
            Json.parseToJsonElement(frame).jsonArray.map { it.jsonObject }
                .filter { it["method"]?.jsonPrimitive?.content == "announce" }
                .mapNotNull { it["params"]?.jsonObject }
                .firstOrNull { it["name"]?.jsonPrimitive?.content == TOPIC }
                ?.get("id")?.jsonPrimitive?.content?.toLongOrNull()
        } catch (_: IllegalArgumentException) {
            // A frame that is not of NetworkTables is ignored.
            null
        }

        private fun controlIn(frame: ByteBuffer) {
            try {
                val reader = MessagePackReader(frame)
                while (reader.hasNext && reader.arraySize() == ELEMENTS) {
                    val id = reader.number()
                    reader.number()
                    reader.number()
                    val value = reader.number() ?: return
                    if (id == topic) set(value)
                }
            } catch (_: BufferUnderflowException) {
                // The frame is cut; the next one repeats the value.
            }
        }
    }

    private fun set(value: Long) = lock.withLock {
        control = value
        change.signalAll()
    }

    private fun lose() = lock.withLock {
        isLost = true
        change.signalAll()
    }

    private companion object {
        const val TOPIC = "/FMSInfo/FMSControlData"
        const val ENABLED = 1L

        /** The topic's id, a time, a type and a value. */
        const val ELEMENTS = 4

        /** A server's message about one topic is much shorter. */
        const val MAX_MESSAGE = 1 shl 16
    }
}
