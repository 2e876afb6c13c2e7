package badlog.networktables.replay

import badlog.networktables.SubProtocol
import org.java_websocket.WebSocketImpl
import org.java_websocket.drafts.Draft
import org.java_websocket.drafts.Draft_6455
import org.java_websocket.enums.HandshakeState
import org.java_websocket.enums.Opcode
import org.java_websocket.exceptions.IncompleteHandshakeException
import org.java_websocket.exceptions.InvalidHandshakeException
import org.java_websocket.exceptions.LimitExceededException
import org.java_websocket.framing.Framedata
import org.java_websocket.handshake.ClientHandshake
import org.java_websocket.handshake.Handshakedata
import org.java_websocket.protocols.Protocol
import java.net.URI
import java.net.URISyntaxException
import java.nio.ByteBuffer

/**
 * WebSockets of NT4, for programs on this computer. Handshakes and messages are limited in length, and no web page from the internet may
 * connect.
 *
 * @param ownHost the address at which the server listens; pages from it may connect.
 * @param refuse called for each refused message or handshake, with the client and a description as part of a sentence.
 */
internal class BoundedDraft(private val ownHost: String, private val refuse: (client: String, what: String) -> Unit) :
    Draft_6455(emptyList(), SubProtocol.entries.map { Protocol(it.id) }, MAX_FRAME) {
    private var pieces = 0

    override fun translateHandshake(bytes: ByteBuffer): Handshakedata = bounded(bytes, { refuse(NOBODY, "an unfinished handshake") }) {
        super.translateHandshake(bytes)
    }

    override fun acceptHandshakeAsServer(request: ClientHandshake): HandshakeState {
        val origin = request.getFieldValue("Origin")
        if (!isForeign(origin)) return super.acceptHandshakeAsServer(request)
        refuse(NOBODY, "a request of the web page $origin, which may not connect")
        return HandshakeState.NOT_MATCHED
    }

    override fun processFrame(socket: WebSocketImpl, frame: Framedata) {
        when (frame.opcode) {
            Opcode.CONTINUOUS -> pieces++
            Opcode.TEXT, Opcode.BINARY -> pieces = 0
            else -> Unit
        }
        if (pieces > MAX_PIECES) {
            refuse(socket.getAttachment<Connection?>()?.name ?: NOBODY, "an unfinished message")
            throw LimitExceededException("More than $MAX_PIECES pieces.", MAX_PIECES)
        }
        super.processFrame(socket, frame)
    }

    override fun copyInstance(): Draft = BoundedDraft(ownHost, refuse)

    /**
     * Returns whether [origin] is foreign. Programs send no origin, or one on their own disk; pages served by this computer are allowed.
     */
    private fun isForeign(origin: String): Boolean {
        if (origin.isBlank()) return false
        val scheme = origin.substringBefore("://", "")
        // An embedded page can hide its origin.
        if (scheme.isEmpty()) return true
        if (scheme.lowercase() !in listOf("http", "https")) return false
        val host = try {
            URI(origin).host
        } catch (_: URISyntaxException) {
            return true
        }
        return host !in LOOPBACK && host != ownHost
    }

    internal companion object {
        private const val MAX_FRAME = 1 shl 20
        private const val MAX_PIECES = 1000
        private const val MAX_HANDSHAKE = 1 shl 14
        private const val NOBODY = "somebody"
        private val LOOPBACK = listOf("localhost", "127.0.0.1", "[::1]", "::1")

        /** Returns the result of [read] for the handshake [bytes] received so far; calls [onEndless] if it is too long. */
        inline fun bounded(bytes: ByteBuffer, onEndless: () -> Unit, read: () -> Handshakedata): Handshakedata {
            val size = bytes.remaining()
            return try {
                read()
            } catch (e: IncompleteHandshakeException) {
                if (size <= MAX_HANDSHAKE) throw e
                onEndless()
                throw InvalidHandshakeException("The handshake is too long.")
            }
        }
    }
}
