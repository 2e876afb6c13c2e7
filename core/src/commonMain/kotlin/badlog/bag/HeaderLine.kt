package badlog.bag

import badlog.recording.Recording

/**
 * Line 1 of the bag that [recording] makes: its own, where that describes just these topics and values; else one that does,
 * with the unknown keys of the recording's own.
 */
internal fun headerLineOf(recording: Recording): String {
    val line = recording.headerLine
    val own = line?.let(::readHeader) ?: BagHeader()
    val topics = recording.topics.map { topic ->
        val title = RowWriter.titleOf(topic.name)
        BagTopic(title, topic.unit, topic.attributes, own.topics.find { it.name == topic.name }?.unknown.orEmpty())
    }
    val values = recording.values.map { value -> own.values.find { it.value == value } ?: BagValue(value) }
    val header = BagHeader(topics, values, own.unknown)
    val isTrue = header == own && topics.all { isText(it.name) }
    return if (line != null && isTrue && isOneLine(line)) line else headerText(header)
}

private fun isOneLine(line: String) = line.startsWith('{') && line.none { isLineEnd(it.code) }

/** False for a lone half of a surrogate pair, which JSON can name but no line of titles can hold. */
private fun isText(name: String) = name.encodeToByteArray().decodeToString() == name
