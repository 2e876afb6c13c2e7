package badlog.networktables.replay

import org.java_websocket.drafts.Draft
import org.java_websocket.drafts.Draft_6455
import org.java_websocket.enums.CloseHandshakeType
import org.java_websocket.enums.HandshakeState
import org.java_websocket.handshake.ClientHandshake
import org.java_websocket.handshake.HandshakeBuilder
import org.java_websocket.handshake.Handshakedata
import org.java_websocket.handshake.ServerHandshakeBuilder
import java.nio.ByteBuffer

/**
 * Answers a plain HTTP request, which AdvantageScope sends before it connects. The server sees it as a connection,
 * which must be closed as soon as it is open.
 */
internal class AliveAnswer : Draft_6455() {
    override fun acceptHandshakeAsServer(request: ClientHandshake): HandshakeState =
        if (request.getFieldValue("Upgrade").equals("websocket", ignoreCase = true)) {
            HandshakeState.NOT_MATCHED
        } else {
            HandshakeState.MATCHED
        }

    override fun postProcessHandshakeResponseAsServer(request: ClientHandshake, response: ServerHandshakeBuilder): HandshakeBuilder =
        response

    override fun createHandshake(handshake: Handshakedata): List<ByteBuffer> = createHandshake(handshake, true)

    override fun createHandshake(handshake: Handshakedata, withContent: Boolean): List<ByteBuffer> =
        listOf(ByteBuffer.wrap(ANSWER.encodeToByteArray()))

    override fun translateHandshake(bytes: ByteBuffer): Handshakedata = BoundedDraft.bounded(bytes, {}) { super.translateHandshake(bytes) }

    override fun getCloseHandshakeType(): CloseHandshakeType = CloseHandshakeType.NONE

    override fun copyInstance(): Draft = AliveAnswer()
}

private const val TEXT = "badlog replays a log here, for dashboards that speak NetworkTables 4.\n"

// Dashboards may be web pages of another origin.
private const val ANSWER = "HTTP/1.1 200 OK\r\nContent-Type: text/plain; charset=utf-8\r\nContent-Length: ${TEXT.length}\r\n" +
    "Access-Control-Allow-Origin: *\r\nConnection: close\r\n\r\n$TEXT"
