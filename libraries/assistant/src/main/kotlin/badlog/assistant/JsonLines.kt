package badlog.assistant

import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import java.io.ByteArrayOutputStream
import java.io.InputStream

/**
 * The lines of [input] that are objects or arrays of JSON. The SDK drops other lines without an answer, for which a client may wait.
 *
 * @param onOther called for each other line that is not empty.
 */
internal class JsonLines(input: InputStream, private val onOther: () -> Unit) : InputStream() {
    private val input = input.buffered()
    private var line = ByteArray(0)
    private var next = 0
    private var hasEnded = false

    override fun read(): Int = if (fill()) line[next++].toInt() and BYTE else -1

    override fun read(bytes: ByteArray, offset: Int, length: Int): Int {
        if (length == 0) return 0
        if (!fill()) return -1
        val count = minOf(length, line.size - next)
        line.copyInto(bytes, offset, next, next + count)
        next += count
        return count
    }

    override fun close() = input.close()

    /** Reads the next line that is JSON, if the last one was taken. Returns false at the end. */
    private fun fill(): Boolean {
        while (next == line.size) {
            if (hasEnded) return false
            line = readLine()
            next = 0
            val text = line.decodeToString()
            if (text.isNotBlank() && !isJson(text)) {
                line = ByteArray(0)
                onOther()
            }
        }
        return true
    }

    private fun readLine(): ByteArray {
        val bytes = ByteArrayOutputStream()
        while (true) {
            val byte = input.read()
            hasEnded = byte < 0
            if (hasEnded) break
            bytes.write(byte)
            if (byte == LINE_FEED) break
        }
        return bytes.toByteArray()
    }

    // The parser accepts a single word as a value.
    private fun isJson(text: String) = try {
        Json.parseToJsonElement(text).let { it is JsonObject || it is JsonArray }
    } catch (_: SerializationException) {
        false
    }
}

private const val BYTE = 0xFF
private const val LINE_FEED = 10
