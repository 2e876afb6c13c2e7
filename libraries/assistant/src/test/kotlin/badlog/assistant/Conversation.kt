package badlog.assistant

import badlog.assistant.log.LogFolder
import badlog.assistant.log.LogLake
import io.kotest.assertions.withClue
import io.kotest.matchers.shouldBe
import io.modelcontextprotocol.kotlin.sdk.client.Client
import io.modelcontextprotocol.kotlin.sdk.client.StdioClientTransport
import io.modelcontextprotocol.kotlin.sdk.types.CallToolResult
import io.modelcontextprotocol.kotlin.sdk.types.ImageContent
import io.modelcontextprotocol.kotlin.sdk.types.Implementation
import io.modelcontextprotocol.kotlin.sdk.types.TextContent
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.withTimeout
import kotlinx.io.asSink
import kotlinx.io.asSource
import kotlinx.io.buffered
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.channels.Channels
import java.nio.channels.Pipe
import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64
import kotlin.io.path.writeText

/** The samples of the project. */
internal val SAMPLES: Path = Path.of("../../samples")

/** An assistant that talks with the server. */
internal class Conversation(val client: Client) {
    /** Returns the server's answer to a call of [tool] with [arguments]. */
    suspend fun call(tool: String, vararg arguments: Pair<String, Any?>): CallToolResult = client.callTool(name = tool, arguments = arguments.toMap())

    /** Returns the text of that answer. */
    suspend fun text(tool: String, vararg arguments: Pair<String, Any?>): String = textOf(call(tool, *arguments))

    /** Returns the data of that answer, which must not be a failure. */
    suspend fun data(tool: String, vararg arguments: Pair<String, Any?>): JsonObject {
        val result = call(tool, *arguments)
        withClue(textOf(result)) { (result.isError ?: false) shouldBe false }
        return Json.parseToJsonElement(textOf(result)).jsonObject.getValue("data").jsonObject
    }

    /** Returns the sentence with which the server refuses a call. */
    suspend fun refusal(tool: String, vararg arguments: Pair<String, Any?>): String {
        val result = call(tool, *arguments)
        withClue(textOf(result)) { result.isError shouldBe true }
        return textOf(result)
    }

    companion object {
        fun textOf(result: CallToolResult): String = result.content.filterIsInstance<TextContent>().single().text

        fun pictureOf(result: CallToolResult): ByteArray = Base64.getDecoder().decode(result.content.filterIsInstance<ImageContent>().single().data)
    }
}

/** Lets [talk] ask about the logs in [folder], through the protocol itself. */
internal fun asking(folder: Path, talk: suspend Conversation.() -> Unit) {
    val toServer = Pipe.open()
    val toClient = Pipe.open()
    val logs = LogFolder(folder)
    val caches = Files.createTempDirectory("badlog-assistant-cache")
    val lake = LogLake(logs, caches.resolve("answers"), checkNotNull(seasonService()))
    val server = AssistantServer(toolsOf(logs, cache = null, lake), logs.root.toString())
    runBlocking {
        val serving = launch(Dispatchers.IO) {
            server.serve(Channels.newInputStream(toServer.source()), Channels.newOutputStream(toClient.sink()))
        }
        val client = Client(Implementation(name = "a test", version = "1"))
        withTimeout(TIME_LIMIT) {
            client.connect(
                StdioClientTransport(
                    Channels.newInputStream(toClient.source()).asSource().buffered(),
                    Channels.newOutputStream(toServer.sink()).asSink().buffered(),
                ),
            )
            Conversation(client).talk()
        }
        toServer.sink().close()
        serving.join()
        client.close()
    }
    caches.toFile().deleteRecursively()
}

/** Writes a file [name] with [content] into this folder. */
internal fun Path.with(name: String, content: String): Path = resolve(name).apply {
    Files.createDirectories(parent)
    writeText(content)
}

/** Returns a small bag with the topic [topic], the value [value] and the event [event]. */
internal fun bag(topic: String = "Speed", value: String = "42", event: String = "go"): String {
    fun quoted(text: String) = Json.encodeToString(text)
    return """
        {"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":${quoted(topic)},"unit":"m/s"},{"name":"Log","attrs":["log"]}],"values":[{"name":"Match Number","value":${quoted(value)}}]}
        Time,${csv(topic)},Log
        0,1.5,
        0.02,2.5,${csv(event)}
        0.04,3.5,

    """.trimIndent()
}

private fun csv(text: String) = "\"" + text.replace("\"", "\"\"") + "\""

internal fun JsonObject.array(name: String): JsonArray = getValue(name).jsonArray

internal fun JsonElement.text(name: String): String = jsonObject.getValue(name).jsonPrimitive.content

internal fun JsonArray.texts(name: String): List<String> = map { it.text(name) }

/** A limit for busy machines, in ms. */
private const val TIME_LIMIT = 300_000L
