package badlog.core.json

import badlog.core.number.DecimalReader
import badlog.core.text.isLetterOrDigit

/**
 * A value of a JSON text.
 *
 * @property json the value exactly as in the text.
 * @property text its content if it is a string; otherwise null.
 * @property items its items if it is an array; otherwise null.
 * @property members its members in order if it is an object; otherwise null.
 * @property start the index in the text at which it begins.
 */
public class JsonValue internal constructor(
    public val json: String,
    public val start: Int,
    public val text: String? = null,
    public val items: List<JsonValue>? = null,
    public val members: List<JsonMember>? = null,
)

/**
 * A member of a JSON object.
 *
 * @property key its name, which need not be unique.
 */
public class JsonMember internal constructor(public val key: String, public val value: JsonValue)

/**
 * Reads JSON as defined by RFC 8259, with one exception: control characters are allowed in strings.
 *
 * It exists because the platforms' own readers accept different texts and treat numbers differently, while page and viewer must show the
 * same. A JSON library would also be most of a page's script.
 */
public class JsonReader private constructor(private val text: String) {
    private var at = 0

    private class Malformed : Exception()

    private fun document(): JsonValue {
        val value = value(0)
        skipBlanks()
        if (at < text.length) throw Malformed()
        return value
    }

    private fun value(depth: Int): JsonValue {
        if (depth > MAX_DEPTH) throw Malformed()
        skipBlanks()
        val start = at
        return when (peek()) {
            '{' -> members(depth).let { JsonValue(text.substring(start, at), start, members = it) }
            '[' -> items(depth).let { JsonValue(text.substring(start, at), start, items = it) }
            '"' -> string().let { JsonValue(text.substring(start, at), start, text = it) }
            else -> word().let { JsonValue(it, start) }
        }
    }

    private fun members(depth: Int): List<JsonMember> = list('}') {
        skipBlanks()
        if (peek() != '"') throw Malformed()
        val key = string()
        skipBlanks()
        expect(':')
        JsonMember(key, value(depth + 1))
    }

    private fun items(depth: Int): List<JsonValue> = list(']') { value(depth + 1) }

    private inline fun <T> list(end: Char, item: () -> T): List<T> {
        val list = ArrayList<T>()
        at++
        skipBlanks()
        if (peek() == end) {
            at++
            return list
        }
        while (true) {
            list += item()
            skipBlanks()
            if (peek() == end) break
            expect(',')
        }
        at++
        return list
    }

    private fun string(): String {
        val start = ++at
        while (peek() != '"' && peek() != '\\') at++
        if (peek() == '"') return text.substring(start, at++)
        val string = StringBuilder().append(text, start, at)
        while (true) {
            val char = peek()
            at++
            when (char) {
                '"' -> return string.toString()
                '\\' -> string.append(escaped())
                else -> string.append(char)
            }
        }
    }

    private fun escaped(): Char {
        val char = peek()
        at++
        return when (char) {
            '"', '\\', '/' -> char
            'b' -> '\b'
            'f' -> '\u000C'
            'n' -> '\n'
            'r' -> '\r'
            't' -> '\t'
            'u' -> hexadecimal()
            else -> throw Malformed()
        }
    }

    private fun hexadecimal(): Char {
        if (at + 4 > text.length) throw Malformed()
        var code = 0
        repeat(4) {
            val digit = text[at++].digitToIntOrNull(16) ?: throw Malformed()
            code = code * 16 + digit
        }
        return code.toChar()
    }

    /** Returns `true`, `false`, `null` or a number. */
    private fun word(): String {
        val start = at
        while (at < text.length && (isLetterOrDigit(text[at]) || text[at] in "+-.")) at++
        val word = text.substring(start, at)
        if (word != "true" && word != "false" && word != "null" && !isNumber(word)) {
            at = start
            throw Malformed()
        }
        return word
    }

    private fun isNumber(word: String): Boolean {
        val digits = word.removePrefix("-")
        val hasLeadingZero = digits.length > 1 && digits[0] == '0' && digits[1] in '0'..'9'
        if (digits.isEmpty() || digits[0] !in '0'..'9' || hasLeadingZero) return false
        val point = digits.indexOf('.')
        if (point >= 0 && (point + 1 == digits.length || digits[point + 1] !in '0'..'9')) return false
        val bytes = digits.encodeToByteArray()
        return DecimalReader().read(bytes, 0, bytes.size)
    }

    private fun skipBlanks() {
        while (at < text.length && isBlank(text[at])) at++
    }

    // Faster than searching a string of all of them, which matters for a page with its rules.
    private fun isBlank(char: Char) = char == ' ' || char == '\n' || char == '\t' || char == '\r'

    private fun peek(): Char = if (at < text.length) text[at] else throw Malformed()

    private fun expect(char: Char) {
        if (peek() != char) throw Malformed()
        at++
    }

    public companion object {
        // Far deeper than any header, and far below the limit of a stack.
        private const val MAX_DEPTH = 100

        /** Returns the members of the JSON object in [text], or null if [text] is not exactly one object. */
        public fun readObject(text: String): List<JsonMember>? = try {
            JsonReader(text).document().members
        } catch (_: Malformed) {
            null
        }

        /** Returns the index at which [text] stops being JSON; null if all of it is. */
        public fun mistakeIn(text: String): Int? = JsonReader(text).run {
            try {
                document()
                null
            } catch (_: Malformed) {
                at
            }
        }
    }
}

/** Returns [text] as a JSON string, with its quotes, on one line. Characters beyond ASCII are not escaped. */
public fun quotedJson(text: String): String = StringBuilder(text.length + 2).appendQuotedJson(text).toString()

/** Appends [text] in the form of [quotedJson]. */
internal fun StringBuilder.appendQuotedJson(text: String): StringBuilder {
    append('"')
    for (char in text) {
        when {
            char == '"' || char == '\\' -> append('\\').append(char)
            char < ' ' || char == '\u2028' || char == '\u2029' -> append("\\u").append(char.code.toString(16).padStart(4, '0'))
            else -> append(char)
        }
    }
    return append('"')
}
