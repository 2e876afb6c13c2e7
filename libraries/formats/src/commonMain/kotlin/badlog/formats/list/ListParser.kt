package badlog.formats.list

import badlog.core.recording.LogParser
import badlog.core.recording.Loss
import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.recording.Recording
import badlog.core.recording.Value
import badlog.core.recording.timesText
import badlog.core.text.wallTimeText
import badlog.formats.column.ColumnSource
import badlog.formats.column.addTooMany

/**
 * Reads a [list of samples][ListFormat] that is pushed to it in pieces of any size. It never throws because of the bytes: whatever is
 * wrong becomes a problem of the recording. Besides the samples, it holds one line of the file in memory. Not thread-safe.
 */
internal class ListParser(keepSamples: Boolean) : LogParser {
    private val problems = ProblemList()
    private val topics = ListTopics(ColumnSource(keepSamples), problems)
    private val first = ByteArray(ListFormat.signatureSize)
    private var firstSize = 0
    private var rows: ListRows? = null
    private var badRows = 0
    private var firstBadLine = 0

    override val rowCount: Int get() = topics.sampleCount

    override var maxRows: Int = MAX_SAMPLES

    override var isFull: Boolean = false
        private set

    override fun accept(bytes: ByteArray, from: Int, until: Int) {
        var at = from
        while (at < until && firstSize < first.size) first[firstSize++] = bytes[at++]
        if (firstSize < first.size) return
        for (i in at until until) {
            if (isFull) return
            val rows = started()
            rows.accept(bytes[i])
            if (rows.isTooLong) isFull = true
        }
    }

    override fun finish(): Recording {
        val rows = started()
        rows.finish()
        if (rows.isTooLong) {
            problems.add(ProblemKind.ROW_CUT, TOO_LONG, rows.line)
        } else if (isFull) {
            problems.addTooMany(maxRows)
        }
        reportBadRows()
        val all = topics.build()
        if (topics.sampleCount == 0) problems.add(ProblemKind.NO_ROWS, "There is a header, but there are no samples.")
        val start = if (topics.origin > 0) wallTimeText(topics.origin) else null
        return Recording(ListFormat, null, listOfNotNull(start?.let { Value("Start Time", it) }), all, 0, problems.toList())
    }

    private fun started(): ListRows = rows ?: ListRows(separator(), ::take).also { created ->
        rows = created
        for (i in 0 until firstSize) created.accept(first[i])
    }

    private fun separator() = ListFormat.separatorIn(first, firstSize) ?: ','.code

    private fun take(row: ListRow) {
        // The titles.
        if (row.line == 1) return
        if (topics.sampleCount >= maxRows) {
            isFull = true
        } else if (!topics.add(row)) {
            if (badRows++ == 0) firstBadLine = row.line
        }
    }

    private fun reportBadRows() {
        if (badRows == 0) return
        problems.add(
            ProblemKind.ROW_CUT,
            "Lines that do not have a time, a name and a value were dropped${timesText(badRows)}.",
            firstBadLine,
            count = badRows,
            loss = Loss(rows = badRows),
        )
    }
}

private const val TOO_LONG = "A line of more than ${ListRows.MAX_LINE} bytes is not a sample; the rest of the file was not read."
private const val MAX_SAMPLES = 50_000_000
