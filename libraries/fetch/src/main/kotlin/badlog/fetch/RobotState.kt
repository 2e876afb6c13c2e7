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
 * The enabled state of the robot at [address], from `FMSControlData` of its NetworkTables server, or from `ControlWord` since 2027. Must be
 * closed.
 *
 * @param patience the maximum time to wait for the state.
 * @throws UnknownStateException if the robot does not report it.
 */
internal class RobotState(private val address: RobotAddress, private val patience: Duration) : AutoCloseable {
    private val lock = ReentrantLock()
    private val change = lock.newCondition()
    private var enabled: Boolean? = null
    private var isLost = false
    private val socket = connect()

    init {
        val names = TOPICS.keys.joinToString { "\"$it\"" }
        val json = """[{"method":"subscribe","params":{"topics":[$names],"subuid":1,"options":{}}}]"""
        socket.sendText(json, true)
        var left = patience.toNanos()
        lock.withLock {
            while (enabled == null && !isLost && left > 0) left = change.awaitNanos(left)
            if (enabled == null) {
                socket.abort()
                throw UnknownStateException(address, "its NetworkTables have none of ${TOPICS.keys.joinToString()}")
            }
        }
    }

    /**
     * Whether the robot is currently enabled.
     *
     * @throws UnknownStateException if the connection was lost.
     */
    val isEnabled: Boolean get() = lock.withLock {
        if (isLost) throw UnknownStateException(address, "its NetworkTables no longer answer")
        enabled == true
    }

    /** Waits until the robot is disabled. Throws the same exceptions as [isEnabled]. */
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

        /** The bit with the enabled state, by the id of the topic. */
        private val bits = HashMap<Long, Long>()

        override fun onText(socket: WebSocket, part: CharSequence, isLast: Boolean): CompletionStage<*>? {
            text.append(part)
            if (isLast) {
                announced(text.toString())
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

        /** Stores the ids that the server assigns to the topics in [frame]. */
        private fun announced(frame: String) {
            try {
                for (message in Json.parseToJsonElement(frame).jsonArray.map { it.jsonObject }) {
                    if (message["method"]?.jsonPrimitive?.content != "announce") continue
                    val topic = message["params"]?.jsonObject ?: continue
                    val bit = TOPICS[topic["name"]?.jsonPrimitive?.content] ?: continue
                    topic["id"]?.jsonPrimitive?.content?.toLongOrNull()?.let { bits[it] = bit }
                }
            } catch (_: IllegalArgumentException) {
                // A frame of another protocol is ignored.
            }
        }

        private fun controlIn(frame: ByteBuffer) {
            try {
                val reader = MessagePackReader(frame)
                while (reader.hasNext && reader.arraySize() == ELEMENTS) {
                    val id = reader.number()
                    reader.number()
                    reader.number()
                    val bit = bits[id]
                    val value = reader.word() ?: return
                    if (bit != null) set(value and bit != 0L)
                }
            } catch (_: BufferUnderflowException) {
                // The frame is cut; the next one repeats the value.
            }
        }
    }

    private fun set(isEnabled: Boolean) = lock.withLock {
        enabled = isEnabled
        change.signalAll()
    }

    private fun lose() = lock.withLock {
        isLost = true
        change.signalAll()
    }

    private companion object {
        /** The topics with the enabled state, and its bit. Since 2027 it is a struct, which moved to another folder after the alphas. */
        val TOPICS = mapOf(
            "/FMSInfo/FMSControlData" to 1L,
            "/FMSInfo/ControlWord" to (1L shl 58),
            "/DriverStation/ControlWord" to (1L shl 58),
        )

        /** The number of elements of a message: the topic's id, a time, a type and a value. */
        const val ELEMENTS = 4

        /** The maximum length of a message; messages about one topic are much shorter. */
        const val MAX_MESSAGE = 1 shl 16
    }
}
