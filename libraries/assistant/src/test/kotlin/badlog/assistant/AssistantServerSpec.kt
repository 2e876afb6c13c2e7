package badlog.assistant

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.modelcontextprotocol.kotlin.sdk.shared.AbstractTransport
import io.modelcontextprotocol.kotlin.sdk.shared.TransportSendOptions
import io.modelcontextprotocol.kotlin.sdk.types.JSONRPCMessage
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.withTimeout
import kotlin.time.Duration.Companion.minutes

/** A conversation that ends as soon as the server begins to listen. */
private class ShortConversation : AbstractTransport() {
    var isClosed = false
        private set

    override suspend fun start() = close()

    override suspend fun send(message: JSONRPCMessage, options: TransportSendOptions?) = Unit

    override suspend fun close() {
        isClosed = true
        invokeOnCloseCallback()
    }
}

class AssistantServerSpec : FunSpec({
    test("the server ends with a conversation that is over before its session is made, as under Wine") {
        val conversation = ShortConversation()
        // The limit only serves to end a failed test.
        runBlocking { withTimeout(2.minutes) { AssistantServer(emptyList(), "logs").serve(conversation) } }
        conversation.isClosed shouldBe true
    }
})
