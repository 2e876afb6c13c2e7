package badlog.page.reading

import badlog.core.recording.CellCounts
import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.recording.Value
import badlog.formats.RECORDING_FORMATS

/**
 * A recording as a message between the worker and the page. It consists of plain arrays and objects, which the browser can copy, and of
 * buffers with the samples, which are transferred instead of copied.
 */
internal object RecordingMessage {
    /** Returns [recording] as a message. */
    fun of(recording: Recording): dynamic {
        val message = js("({})")
        message.format = recording.format.id
        message.headerLine = recording.headerLine
        message.rowCount = recording.rowCount
        message.values = recording.values.map { arrayOf(it.name, it.text) }.toTypedArray()
        message.topics = recording.topics.map(::ofTopic).toTypedArray()
        message.problems = recording.problems
            .map { arrayOf<Any?>(it.kind.ordinal, it.message, it.line, it.topic, it.count) }.toTypedArray()
        return message
    }

    /** Returns the buffers of [recording] to transfer. */
    fun buffersOf(recording: Recording): Array<dynamic> {
        // Topics may share times, and empty columns share one array, but no buffer may be transferred twice.
        val buffers = js("new Set()")
        for (topic in recording.topics) {
            for (array in arrayOf<dynamic>(topic.samples, topic.times, topic.texts.rows, topic.texts.ids)) {
                if (array != null && array.length > 0) buffers.add(array.buffer)
            }
        }
        return js("Array").from(buffers).unsafeCast<Array<dynamic>>()
    }

    /** Returns the recording in [message]. */
    fun read(message: dynamic): Recording = Recording(
        format = RECORDING_FORMATS.first { it.id == message.format },
        headerLine = message.headerLine as String?,
        values = message.values.unsafeCast<Array<Array<String>>>().map { Value(it[0], it[1]) },
        topics = message.topics.unsafeCast<Array<dynamic>>().map { readTopic(it) },
        rowCount = message.rowCount as Int,
        problems = message.problems.unsafeCast<Array<Array<dynamic>>>().map { cells ->
            Problem(
                ProblemKind.entries[cells[0] as Int],
                cells[1] as String,
                cells[2] as Int?,
                cells[3] as String?,
                cells[4] as Int,
            )
        },
    )

    private fun ofTopic(topic: Topic): dynamic {
        val message = js("({})")
        message.name = topic.name
        message.unit = topic.unit
        message.attributes = topic.attributes.toTypedArray()
        message.samples = topic.samples
        message.times = topic.times
        message.type = topic.type
        message.metadata = topic.metadata
        message.rows = topic.texts.rows
        message.ids = topic.texts.ids
        message.dictionary = topic.texts.dictionary.toTypedArray()
        message.counts = topic.counts.run { intArrayOf(numbers, notFinite, truthValues, texts, empty, gaps) }
        return message
    }

    private fun readTopic(message: dynamic): Topic {
        val counts = message.counts.unsafeCast<IntArray>()
        return Topic(
            name = message.name as String,
            unit = message.unit as String,
            attributes = message.attributes.unsafeCast<Array<String>>().asList(),
            samples = message.samples.unsafeCast<DoubleArray>(),
            texts = TextColumn(
                message.rows.unsafeCast<IntArray>(),
                message.ids.unsafeCast<IntArray>(),
                message.dictionary.unsafeCast<Array<String>>().asList(),
            ),
            counts = CellCounts(counts[0], counts[1], counts[2], counts[3], counts[4], counts[5]),
            times = message.times.unsafeCast<DoubleArray?>(),
            type = message.type as String,
            metadata = message.metadata as String,
        )
    }
}
