package badlog.bag

import badlog.json.appendQuotedJson

/**
 * Line 1 of a bag, without its newline: JSON on one line, in ASCII apart from the names' own characters. A header that
 * [readHeader] returned comes out with everything it had.
 *
 * Written without a JSON library, because a robot writes it before its first loop and has 256 MB for everything.
 *
 * @param asOriginal true to write the very bytes that the original badlog wrote: a topic's unit stands before its name,
 *   and more characters are escaped than need be.
 */
public fun headerText(header: BagHeader, asOriginal: Boolean = false): String = HeaderText(asOriginal).apply { append(header) }.toString()

private class HeaderText(private val asOriginal: Boolean) {
    private val out = StringBuilder()

    override fun toString() = out.toString()

    fun append(header: BagHeader) = jsonObject(header.unknown) {
        member("topics") { array(header.topics, ::append) }
        member("values") { array(header.values, ::append) }
    }

    private fun append(topic: BagTopic) = jsonObject(topic.unknown) {
        if (asOriginal) member("unit") { quoted(topic.unit) }
        member("name") { quoted(topic.name) }
        if (!asOriginal) member("unit") { quoted(topic.unit) }
        member("attrs") { array(topic.attributes, ::quoted) }
    }

    private fun append(value: BagValue) = jsonObject(value.unknown) {
        member("name") { quoted(value.value.name) }
        member("value") { quoted(value.value.text) }
    }

    private inline fun jsonObject(unknown: Map<String, String>, members: () -> Unit) {
        out.append('{')
        members()
        for ((key, json) in unknown) member(key) { out.append(json) }
        out.append('}')
    }

    private inline fun member(key: String, value: () -> Unit) {
        if (out.last() != '{') out.append(',')
        quoted(key)
        out.append(':')
        value()
    }

    private inline fun <T> array(items: List<T>, item: (T) -> Unit) {
        out.append('[')
        items.forEachIndexed { index, it ->
            if (index > 0) out.append(',')
            item(it)
        }
        out.append(']')
    }

    private fun quoted(text: String) {
        if (!asOriginal) {
            out.appendQuotedJson(text)
            return
        }
        out.append('"')
        for (char in text) escapedAsOriginal(char)
        out.append('"')
    }

    private fun escapedAsOriginal(char: Char) {
        val short = SHORT.indexOf(char)
        when {
            short >= 0 -> out.append('\\').append(SHORT_LETTERS[short])

            char < ' ' || char in '\u007f'..'\u009f' || char in '\u2000'..'\u20ff' ->
                out.append("\\u").append(char.code.toString(16).uppercase().padStart(4, '0'))

            else -> out.append(char)
        }
    }

    private companion object {
        const val SHORT = "\"\\/\b\u000c\n\r\t"
        const val SHORT_LETTERS = "\"\\/bfnrt"
    }
}
