package badlog.rules

/** The text of a finding, with placeholders: `{value} at {time}`. A literal brace is doubled. */
internal class RuleText private constructor(val source: String, private val parts: List<Part>) {
    private class Part(val text: String, val isPlace: Boolean)

    /** Returns whether it has the placeholder [name]. */
    fun has(name: String): Boolean = parts.any { it.isPlace && it.text == name }

    /** Returns the same text with [replacement] in place of [written], both as they are in [source]. */
    fun replacing(written: String, replacement: String): RuleText =
        if (written in source) parse(source.replace(written, replacement)) else this

    /** Returns the text with its placeholders replaced by [found], which must have all of them. */
    fun filled(found: Map<String, String>): String = parts.joinToString("") { if (it.isPlace) found.getValue(it.text) else it.text }

    /** A mistake from [from] until [until] of the text. */
    class Mistake(val from: Int, val until: Int, override val message: String) : Exception(message)

    companion object {
        val PLACES = listOf("value", "time", "match", "file", "topic", "other", "device", "count", "duration", "channels", "meanwhile")

        /** Reads [text], which may have the placeholders [places]; throws a [Mistake]. */
        fun parse(text: String, places: List<String> = PLACES): RuleText {
            val parts = ArrayList<Part>()
            val plain = StringBuilder()
            var at = 0
            while (at < text.length) {
                val char = text[at]
                if ((char == '{' || char == '}') && text.getOrNull(at + 1) == char) {
                    plain.append(char)
                    at += 2
                } else if (char == '{') {
                    val end = text.indexOf('}', at)
                    if (end < 0) throw Mistake(at, at + 1, "This brace is never closed; to print a brace, write it twice.")
                    val place = text.substring(at + 1, end)
                    if (place !in places) {
                        val known = places.joinToString { "{$it}" }
                        throw Mistake(at, end + 1, "“{$place}” is not a placeholder; the placeholders are $known.")
                    }
                    parts += Part(plain.toString(), false)
                    parts += Part(place, true)
                    plain.clear()
                    at = end + 1
                } else {
                    plain.append(char)
                    at++
                }
            }
            parts += Part(plain.toString(), false)
            return RuleText(text, parts)
        }
    }
}
