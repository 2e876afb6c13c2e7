package badlog.bag

/**
 * Line 1 of a bag, without its newline: JSON on one line, in ASCII apart from the names' own characters. A header that
 * [readHeader] returned comes out with everything it had.
 *
 * Written without a JSON library, because a robot writes it before its first loop and has 256 MB for everything.
 */
public fun headerText(header: BagHeader): String = buildString {
    jsonObject(header.unknown) {
        member("topics") { array(header.topics) { appendTopic(it) } }
        member("values") { array(header.values) { appendValue(it) } }
    }
}

private fun StringBuilder.appendTopic(topic: BagTopic) = jsonObject(topic.unknown) {
    member("name") { appendQuoted(topic.name) }
    member("unit") { appendQuoted(topic.unit) }
    member("attrs") { array(topic.attributes) { appendQuoted(it) } }
}

private fun StringBuilder.appendValue(value: BagValue) = jsonObject(value.unknown) {
    member("name") { appendQuoted(value.value.name) }
    member("value") { appendQuoted(value.value.text) }
}

private fun StringBuilder.jsonObject(unknown: Map<String, String>, members: StringBuilder.() -> Unit) {
    append('{')
    members()
    for ((key, json) in unknown) member(key) { append(json) }
    append('}')
}

private fun StringBuilder.member(key: String, value: StringBuilder.() -> Unit) {
    if (last() != '{') append(',')
    appendQuoted(key)
    append(':')
    value()
}

private fun <T> StringBuilder.array(items: List<T>, appendItem: StringBuilder.(T) -> Unit) {
    append('[')
    items.forEachIndexed { index, item ->
        if (index > 0) append(',')
        appendItem(item)
    }
    append(']')
}

private fun StringBuilder.appendQuoted(text: String) {
    append('"')
    for (char in text) {
        when {
            char == '"' || char == '\\' -> append('\\').append(char)
            char < ' ' || char == '\u2028' || char == '\u2029' ->
                append("\\u").append(char.code.toString(16).padStart(4, '0'))
            else -> append(char)
        }
    }
    append('"')
}
