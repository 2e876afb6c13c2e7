package badlog.core.bag

import badlog.core.recording.LogParser
import badlog.core.recording.Loss
import badlog.core.recording.NumberSinks
import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.Topic
import badlog.core.recording.Value
import badlog.core.text.NUL
import badlog.core.text.TextDecoder
import badlog.core.text.wallTimeText

/**
 * Reads a bag or a plain CSV file from pieces of any size. It never throws because of the bytes: anything wrong in them becomes a problem
 * of the recording, by the rules in `docs/bag-format.md`.
 *
 * Besides the recording's columns, it keeps one piece of the file in memory, never the whole file. Compressed files must be inflated first.
 * Not thread-safe.
 *
 * @param expectedBytes the length of the file, which limits the memory of the columns to the need of its rows; 0 if it is not known.
 * @param keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
 */
public class BagParser(private val expectedBytes: Long = 0, private val keepSamples: Boolean = true) : LogParser {
    private var sinks = NumberSinks.RECORDING
    private var expectedLines = 0L
    private var forAll: (count: Int, work: (Int) -> Unit) -> Unit = { count, work -> repeat(count, work) }

    /**
     * Creates a parser that passes the slow work of each column to [forAll].
     *
     * @param sinks receivers of the numbers that the recording does not keep; texts and counts are always kept.
     * @param expectedLines the number of lines of the file, if known, so that columns need not grow at all. 0 if it is not known.
     * @param forAll calls its function for each number from 0 until the first argument, in any order, on several threads if
     *   available, and returns when all calls have returned.
     */
    public constructor(
        expectedBytes: Long,
        keepSamples: Boolean,
        sinks: NumberSinks,
        expectedLines: Long = 0,
        forAll: (count: Int, work: (Int) -> Unit) -> Unit = { count, work -> repeat(count, work) },
    ) : this(expectedBytes, keepSamples) {
        this.sinks = sinks
        this.forAll = forAll
        this.expectedLines = expectedLines
    }

    override var maxRows: Int = MAX_ROWS

    private val decoder = TextDecoder()
    private val problems = ProblemList()
    private val pending = PendingBytes()
    private val header = HeaderReader(pending, decoder, problems)
    private var rows: RowReader? = null
    private var waitsForLineEnd = false
    private var holeBytes = 0L

    override val rowCount: Int get() = rows?.rowCount ?: 0

    override val isFull: Boolean get() = rows?.hasGivenUp == true

    /**
     * The argument for a [RowBatchParser] that reads rows of this file: for each column, whether a decimal comma is read. Null until the
     * header is read, and if no rows follow.
     */
    public val readsDecimalComma: BooleanArray? get() = if (ignoresRest) null else rowReader()?.readsDecimalComma

    private val ignoresRest: Boolean get() = header.isNotLog || isFull

    override fun accept(bytes: ByteArray, from: Int, until: Int) {
        var at = from
        while (at < until && !ignoresRest) {
            val end = minOf(at + PendingBytes.PIECE, until)
            append(bytes, at, end)
            if (!waitsForLineEnd || lineEndIn(bytes, at, end) < end || pending.size > MAX_WAIT) advance(false)
            at = end
        }
    }

    private fun append(bytes: ByteArray, from: Int, until: Int) {
        val translation = header.translation ?: return pending.append(bytes, from, until)
        translation.accept(bytes, from, until)
        pending.append(translation.out, 0, translation.outSize)
    }

    /**
     * Adds rows that a [RowBatchParser] read from the next bytes of the file, in place of those bytes.
     *
     * @return false if no row begins there because a row or a hole continues, if [batch] lacks numbers that this parser keeps
     *   or passes on, or if the file separates cells or writes numbers in an unusual way; the bytes themselves must then be passed.
     */
    public fun accept(batch: RowBatch): Boolean {
        val reader = rowReader()
        if (header.translation != null || reader == null || ignoresRest || pending.size > 0 || holeBytes > 0 ||
            pending.isAfterHole
        ) {
            return false
        }
        return reader.add(batch)
    }

    override fun finish(): Recording {
        header.translation?.let(pending::finish)
        advance(true)
        val rows = rows ?: rowsOf(header.columns ?: columnsWithoutTitles())
        val topics = rows.topics()
        if (rows.origin > 0) header.reportClock(rows.axis)
        if (pending.sawCarriageReturn && !ignoresRest) {
            problems.add(ProblemKind.CARRIAGE_RETURNS, "Lines end in a carriage return, as on Windows; that is fine.")
        }
        if (isProse(topics)) return refused()
        reportEmptiness(topics, rows.rowCount)
        return Recording(
            format = if (header.line != null) RecordingFormat.BAG else RecordingFormat.CSV,
            headerLine = header.line,
            values = values(rows.origin),
            topics = topics,
            rowCount = rows.rowCount,
            problems = problems.toList(),
        )
    }

    /** Returns the file's values, and when it starts, at [origin], unless it says so itself. */
    private fun values(origin: Double): List<Value> {
        val own = header.header?.values.orEmpty().map { it.value }
        val start = header.translation?.startText ?: if (origin > 0) wallTimeText(origin) else null
        return if (start == null || own.any { it.name == START }) own else own + Value(START, start)
    }

    private fun advance(isEnd: Boolean) {
        while (skipHole(isEnd) && pending.size > 0) {
            val next = if (header.isDone) readRow(isEnd) else header.read(isEnd)
            waitsForLineEnd = next == RowScanner.INCOMPLETE
            if (waitsForLineEnd) return
            pending.advanceTo(next)
        }
    }

    private fun readRow(isEnd: Boolean): Int {
        if (ignoresRest) return pending.end
        return rowReader()?.read(isEnd) ?: pending.end
    }

    private fun rowReader(): RowReader? = rows ?: header.columns?.let { rowsOf(it) }?.also { rows = it }

    private fun rowsOf(columns: HeaderColumns) = RowReader(
        pending,
        columns,
        decoder,
        problems,
        keepSamples,
        sinks,
        endsInNewline = header.line != null,
        expectedBytes,
        expectedLines,
        maxRows,
        forAll,
    )

    /** Without a line of titles there are no rows, but the line of JSON may still list the topics. */
    private fun columnsWithoutTitles(): HeaderColumns =
        HeaderColumns.match(header.header, header.header?.topics.orEmpty().map { it.name }, pending.line, problems)

    /** Skips NULs, and reports their number once they end. Returns false if more may follow. */
    private fun skipHole(isEnd: Boolean): Boolean {
        var at = pending.start
        while (at < pending.end && pending.bytes[at].toInt() == NUL) at++
        holeBytes += at - pending.start
        pending.advanceTo(at)
        if (holeBytes == 0L) return true
        if (at == pending.end && !isEnd) return false
        problems.add(
            ProblemKind.NUL_HOLE,
            "NUL bytes ($holeBytes) have replaced data, probably after a power loss; that data is lost.",
            pending.line,
            loss = Loss(bytes = holeBytes),
        )
        holeBytes = 0L
        pending.holeLine = pending.line
        return true
    }

    private fun isProse(topics: List<Topic>) =
        header.header == null && topics.size == 1 && rowCount > 0 && topics[0].counts.run { texts + empty == total }

    private fun refused(): Recording {
        val message = "${HeaderReader.NOT_A_LOG}: it is text without columns of numbers."
        problems.add(ProblemKind.NOT_A_RECORDING, message, 1)
        return Recording(RecordingFormat.CSV, null, emptyList(), emptyList(), 0, problems.toList())
    }

    private fun reportEmptiness(topics: List<Topic>, rowCount: Int) {
        when {
            ignoresRest -> return

            header.line == null && topics.isEmpty() -> problems.add(
                ProblemKind.EMPTY_FILE,
                "The file is empty; the robot may have been switched off too early.",
            )

            rowCount == 0 -> problems.add(
                ProblemKind.NO_ROWS,
                "There is a header but no row of samples; the robot may have been switched off too early.",
            )
        }
    }

    public companion object {
        /** The default maximum of rows: a thousand a second for more than half a day. */
        public const val MAX_ROWS: Int = 50_000_000

        private const val START = "Start Time"

        /** A line that does not end is examined again only when it exceeds the length of any valid line. */
        private const val MAX_WAIT = 1 shl 24
    }
}
