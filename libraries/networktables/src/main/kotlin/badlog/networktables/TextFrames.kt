package badlog.networktables

import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray

/** The id of the topic with which a client asks for the server's time. */
const val TIME_ID: Long = -1

/**
 * Returns the messages in a text frame of NetworkTables 4. The sender is not trusted.
 *
 * @throws UnreadableFrameException if the text is not a JSON list.
 */
fun messagesIn(text: String): JsonArray {
    if (isDeep(text)) throw UnreadableFrameException("JSON that is nested too deeply")
    val messages = try {
        Json.parseToJsonElement(text)
    } catch (_: SerializationException) {
        throw UnreadableFrameException("not JSON")
    }
    return messages as? JsonArray ?: throw UnreadableFrameException("not a list of messages")
}

/**
 * Thrown for a frame that is not one of NetworkTables 4.
 *
 * @property what a description of the frame's content, as part of a sentence.
 */
class UnreadableFrameException(val what: String) : Exception(what)

/** Only an attack on the stack nests deeply. */
private fun isDeep(json: String): Boolean {
    var depth = 0
    var inString = false
    var i = 0
    while (i < json.length) {
        when (json[i]) {
            '\\' -> i++
            '"' -> inString = !inString
            '[', '{' -> if (!inString && ++depth > 100) return true
            ']', '}' -> if (!inString) depth--
        }
        i++
    }
    return false
}
