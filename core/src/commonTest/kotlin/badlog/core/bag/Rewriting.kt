package badlog.core.bag

import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat

/** Writes [recording], and returns the file as text. */
internal fun write(
    recording: Recording,
    format: RecordingFormat = RecordingFormat.BAG,
    rows: IntRange = 0 until recording.rowCount,
): String {
    var text = ByteArray(0)
    RecordingWriter(recording, format).write(rows.first, rows.last + 1) { bytes, size -> text += bytes.copyOf(size) }
    return text.decodeToString()
}

/** The content of a file, whatever its form: [describe] without format, header line and problems, and to the last bit. */
internal fun describeContent(recording: Recording): String = buildString {
    appendLine("${recording.rowCount} rows ${recording.values}")
    for (topic in recording.topics) {
        appendLine("topic ${topic.name} ${topic.unit} ${topic.attributes}")
        appendLine(describeCells(recording, topic.name))
    }
}

/** The cells of the topic [name], to the last bit; no samples are the same as nothing but gaps. */
internal fun describeCells(recording: Recording, name: String): String {
    val topic = recording.topics.first { it.name == name }
    val texts = List(topic.texts.size) { "${topic.texts.rows[it]}:${topic.texts[it]}" }
    val samples = topic.samples.map { if (it.isNaN()) "gap" else it.toRawBits().toString(16) }
        .takeUnless { cells -> cells.all { it == "gap" } }
    return "$name ${topic.kind} $samples $texts"
}
