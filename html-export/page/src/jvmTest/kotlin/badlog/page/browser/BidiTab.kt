package badlog.page.browser

import org.openqa.selenium.bidi.Command
import org.openqa.selenium.bidi.Connection
import org.openqa.selenium.interactions.Sequence
import java.time.Duration
import java.util.Base64

/** A tab over WebDriver BiDi, which Firefox supports without a separate driver. */
internal class BidiTab(private val connection: Connection, private val onClose: () -> Unit) : BrowserTab {
    private val context: String

    init {
        // The tests' servers have their own certificates.
        send("session.new", "capabilities" to mapOf("alwaysMatch" to mapOf("acceptInsecureCerts" to true)))
        context = send("browsingContext.create", "type" to "tab")["context"] as String
        send("browsingContext.setViewport", "context" to context, "viewport" to mapOf("width" to 1280, "height" to 900))
    }

    override fun open(address: String) {
        for (one in listOf("about:blank", address)) send("browsingContext.navigate", "context" to context, "url" to one, "wait" to "complete")
    }

    override fun evaluate(expression: String): String {
        val answer = send(
            "script.evaluate",
            "expression" to "(async () => String(await ($expression)))()",
            "target" to mapOf("context" to context),
            "awaitPromise" to true,
        )
        return (answer["result"] as Map<*, *>?)?.get("value") as String? ?: "failed: $answer"
    }

    override fun perform(sequences: List<Sequence>) {
        send("input.performActions", "context" to context, "actions" to sequences.map { it.encode() })
    }

    override fun screenshot(): ByteArray = Base64.getDecoder().decode(send("browsingContext.captureScreenshot", "context" to context)["data"] as String)

    private fun send(method: String, vararg parameters: Pair<String, Any>): Map<*, *> = connection.sendAndWait(Command<Map<*, *>>(method, mapOf(*parameters), Map::class.java), TIMEOUT)

    override fun close() = onClose()

    private companion object {
        val TIMEOUT: Duration = Duration.ofMinutes(3)
    }
}
