package badlog.core.bag

import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind

/**
 * Writes a recording, or some of its rows, as a file. Read again, the file has the same topics, values and samples: every number to the
 * last bit, and each cell of the same kind.
 *
 * Details that the format cannot express are lost. CSV has neither units, attributes nor values. A newline in a topic's name becomes a
 * space, and a CSV title keeps no control characters but tabs. If a topic has both empty cells and cells with `NaN`, both are written
 * alike. A text with lines that look like rows is read as rows, see `docs/bag-format.md`.
 *
 * @param recording the recording to write; it must have been read with its samples.
 * @param format the format to write; a recording read from a bag can be written as CSV, and vice versa.
 */
public class RecordingWriter(private val recording: Recording, private val format: RecordingFormat = recording.format) {
    /**
     * Writes the header and the rows from [fromRow] until [untilRow].
     *
     * @param progress called after each piece with the number of rows written so far, and the total to be written. An exception from it
     *   stops the writing and is passed on.
     * @param sink receives the file in pieces of about 64 KiB, each `[0, size)` of the array, which is reused after the
     *   call. An exception from it stops the writing and is passed on.
     * @throws IllegalArgumentException if there are no such rows, the recording was read without its samples, its
     * topics have times of their own, or the format is neither bag nor CSV.
     */
    public fun write(
        fromRow: Int = 0,
        untilRow: Int = recording.rowCount,
        progress: (doneRows: Int, totalRows: Int) -> Unit = { _, _ -> },
        sink: (bytes: ByteArray, size: Int) -> Unit,
    ) {
        require(fromRow in 0..untilRow && untilRow <= recording.rowCount) {
            "There are no rows from $fromRow until $untilRow in a recording of ${recording.rowCount}."
        }
        require(format.hasRows) { "This writes bags and CSV, not ${format.title}s." }
        requireSamples()
        val out = RowWriter()
        header(out)
        val cells = recording.topics.map(::TopicCells)
        val total = untilRow - fromRow
        for (row in fromRow until untilRow) {
            for (cell in cells) cell.write(row, out)
            out.endRow()
            if (out.size >= PIECE) {
                sink(out.bytes, out.size)
                out.clear()
                progress(row + 1 - fromRow, total)
            }
        }
        if (out.size > 0) sink(out.bytes, out.size)
        progress(total, total)
    }

    private fun header(out: RowWriter) {
        val names = recording.topics.map { it.name }
        if (format == RecordingFormat.BAG) {
            out.line(headerLineOf(recording))
            if (names.isNotEmpty()) out.titles(names)
        } else if (names.isNotEmpty()) {
            csvTitles(names, out)
        }
    }

    /** A reader recognizes the format by the first characters, so a misleading first title is quoted. */
    private fun csvTitles(names: List<String>, out: RowWriter) {
        val isAlone = names.size == 1
        names.forEachIndexed { index, name ->
            val isLost = { char: Char -> (char < ' ' && char != '\t') || (isAlone && char in SEPARATORS) }
            val title = name.map { if (isLost(it)) ' ' else it }.joinToString("")
            if (index == 0 && MISLEADING.any(title::startsWith)) out.quoted(title) else out.text(title)
        }
        out.endRow()
    }

    private fun requireSamples() {
        for (topic in recording.topics) {
            require(topic.times == null) { "“${topic.name}” has times of its own; rows can be made of it by resampling." }
            val counts = topic.counts
            val isMissing = topic.samples.isEmpty() && counts.texts + counts.empty < counts.total
            require(!isMissing && topic.texts.size == counts.texts) { "The samples of “${topic.name}” were not kept." }
        }
    }

    public companion object {
        /**
         * Returns the number of `NaN` cells of [topic] that are written as empty cells. In memory, `NaN` and an empty cell are the same
         * sample, so a topic with both cannot tell them apart.
         */
        public fun emptiedNaNs(topic: Topic): Int = if (gapsAreNaN(topic)) 0 else writtenNaNs(topic)

        private const val PIECE = 1 shl 16

        /** A one-column file with one of these in its title would be read as a table with that separator. */
        private const val SEPARATORS = ";\t"

        /** The first characters of other files: JSON, a WPILOG, a byte order mark. */
        private val MISLEADING = listOf("{", "WPILOG", "\uFEFF")
    }
}

/**
 * Returns line 1 for writing [recording] as a bag. It is the recording's own line if that describes exactly these topics and values,
 * otherwise a new one with the unknown keys of that line.
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
    return if (line != null && header == own && isOneLine(line)) line else headerText(header)
}

private fun isOneLine(line: String) = line.startsWith('{') && line.none { isLineEnd(it.code) }

/** Writes the cells of one topic, row by row, in ascending order. */
internal class TopicCells(private val topic: Topic) {
    private var nextText = 0
    private val isBoolean = topic.kind == TopicKind.BOOLEAN
    private val gapsAreNaN = gapsAreNaN(topic)

    /** Writes the cell of [row], which must be after the rows of previous calls. */
    fun write(row: Int, out: RowWriter) {
        val texts = topic.texts
        while (nextText < texts.size && texts.rows[nextText] < row) nextText++
        if (nextText < texts.size && texts.rows[nextText] == row) {
            out.text(texts[nextText])
        } else {
            number(if (topic.samples.isEmpty()) Double.NaN else topic.samples[row], out)
        }
    }

    private fun number(number: Double, out: RowWriter) {
        when {
            number.isNaN() && !gapsAreNaN -> out.empty()
            isBoolean && (number == 0.0 || number == 1.0) -> out.truth(number == 1.0)
            else -> out.exact(number)
        }
    }
}

/**
 * Returns whether to write gaps as `NaN`. An empty cell and one with `NaN` are the same sample; if there was only one of the two, the
 * counts show which. If there were both, empty is the better guess, unless the topic's kind would change without `NaN`.
 */
private fun gapsAreNaN(topic: Topic): Boolean {
    val counts = topic.counts
    val written = writtenNaNs(topic)
    if (written == 0) return false
    val emptied = counts.copy(notFinite = counts.notFinite - written, empty = counts.empty + written)
    return counts.empty == 0 || Topic.kindOf(emptied) != topic.kind
}

private fun writtenNaNs(topic: Topic): Int {
    val counts = topic.counts
    return if (counts.notFinite == 0) 0 else maxOf(0, counts.notFinite - topic.samples.count { it.isInfinite() })
}
