package badlog.formats.wpilog

import badlog.core.recording.LogFormat
import badlog.core.recording.LogParser
import badlog.core.recording.Loss
import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.recording.Recording
import badlog.core.recording.Value
import badlog.core.recording.timesText
import badlog.formats.column.ColumnSource
import badlog.formats.column.addCut
import badlog.formats.column.addLost
import badlog.formats.column.addTooMany

/** WPILOG, the format of WPILib's DataLog. */
public object WpilogFormat : LogFormat {
    override val id: String get() = "wpilog"

    override val title: String get() = "WPILOG"

    override val endings: List<String> get() = listOf(".wpilog")

    override val hasRecords: Boolean get() = true

    override val signatureSize: Int get() = RecordSplitter.MAGIC.length

    override fun matches(bytes: ByteArray, size: Int): Boolean =
        size >= signatureSize && RecordSplitter.MAGIC.indices.all { bytes[it].toInt() == RecordSplitter.MAGIC[it].code }

    override fun parser(keepSamples: Boolean): LogParser = WpilogParser(keepSamples)
}

/**
 * Reads a WPILOG, the log of WPILib's DataLog, that is pushed to it in pieces of any size. It never throws because of the
 * bytes: whatever is wrong becomes a problem of the recording, by the rules in `docs/wpilog.md`.
 *
 * Besides the samples, at most 16 bytes per number, it holds one record of the file in memory, or a megabyte around damage,
 * never the whole file. Compressed files must be inflated first. Not thread-safe.
 *
 * @param keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
 * @param isWanted returns whether the samples of the entry with this name are wanted; others are left out as if there were none.
 */
public class WpilogParser(keepSamples: Boolean = true, isWanted: (String) -> Boolean = { true }) : LogParser {
    private val problems = ProblemList()
    private val entries = WpilogEntries(ColumnSource(keepSamples), problems, isWanted)
    private val splitter = RecordSplitter(entries)

    /** The number of records of all kinds read so far. */
    override val rowCount: Int get() = entries.recordCount

    override var maxRows: Int = MAX_RECORDS

    override var isFull: Boolean = false
        private set

    /** The time of day of the first sample, in µs since 1970, if a log shows it; valid after [finish]. */
    internal val startMicros: Double? get() = entries.match.startMicros(entries.histogram.largestCluster()?.from ?: 0.0)

    override fun accept(bytes: ByteArray, from: Int, until: Int) {
        var at = from
        while (at < until && !isFull) {
            val end = minOf(at + PIECE, until)
            if (rowCount < maxRows) splitter.accept(bytes, at, end) else isFull = true
            at = end
        }
    }

    override fun finish(): Recording {
        if (!isFull) splitter.finish()
        val isOther = !splitter.isPastHeader && !splitter.isInHeader
        val refusal = entries.refusal ?: if (isOther) "This is not a WPILOG file." else null
        if (refusal != null) {
            problems.add(ProblemKind.NOT_A_RECORDING, refusal)
            return Recording(WpilogFormat, null, emptyList(), emptyList(), 0, problems.toList())
        }
        if (isFull) problems.addTooMany(maxRows) else reportEnd()
        entries.finish()
        val cluster = entries.histogram.largestCluster()
        reportLostRecords(cluster)
        val span = (cluster?.from ?: 0.0) / WpilogEntries.MICROS..((cluster?.until ?: 1.0) - 1) / WpilogEntries.MICROS
        val topics = WpilogTopics(span, problems).of(entries.all)
        if (topics.all { it.size == 0 }) {
            problems.add(ProblemKind.NO_ROWS, "There are no samples; the robot may have been switched off too early.")
        }
        return Recording(
            format = WpilogFormat,
            headerLine = null,
            values = entries.match.values(cluster?.from ?: 0.0) + extraHeader(),
            topics = topics,
            rowCount = 0,
            problems = problems.toList(),
        )
    }

    private fun extraHeader() = if (entries.extraHeader.isBlank() || entries.extraHeader == OWN_HEADER) {
        emptyList()
    } else {
        listOf(Value("Extra Header", entries.extraHeader))
    }

    private fun reportEnd() {
        val end = splitter.readableEnd
        if (end >= 0) {
            problems.addLost(end, splitter.total)
        } else if (splitter.pendingBytes > 0 || !splitter.isPastHeader) {
            problems.addCut(splitter.pendingBytes)
        }
    }

    private fun reportLostRecords(cluster: TimeHistogram.Cluster?) {
        if (entries.unknownCount > 0) {
            val numbers = entries.unknownIds.take(NAMED).joinToString { it.toUInt().toString() }
            val more = if (entries.unknownIds.size > NAMED) ", …" else ""
            val isOne = entries.unknownCount == 1
            val records = if (isOne) "1 record belongs" else "${entries.unknownCount} records belong"
            val owners = if (entries.unknownIds.size == 1) "an entry (number $numbers)" else "entries (numbers $numbers$more)"
            val cause = if (entries.hasGaps) {
                "whose start may be among the skipped bytes"
            } else {
                "that this file never starts, or has finished"
            }
            problems.add(
                ProblemKind.UNKNOWN_ENTRY,
                "$records to $owners $cause, and ${if (isOne) "was" else "were"} dropped.",
                count = entries.unknownCount,
                loss = Loss(cells = entries.unknownCount),
            )
        }
        if (entries.badControlCount > 0) {
            problems.add(
                ProblemKind.BAD_RECORD,
                "Malformed records that should start, describe or finish an entry were dropped${timesText(entries.badControlCount)}.",
                count = entries.badControlCount,
                loss = Loss(cells = entries.badControlCount),
            )
        }
        if (entries.earlyCount > 0) {
            problems.add(
                ProblemKind.EARLY_TIMES,
                "Records from before the robot's clock started, such as one of “${entries.firstEarly?.name}”, " +
                    "were moved to the start of the log${timesText(entries.earlyCount)}.",
                count = entries.earlyCount,
            )
        }
        val far = if (cluster == null) 0 else (entries.histogram.total() - cluster.records).toInt()
        if (entries.wildCount + far > 0) {
            val example = entries.firstWild?.let { ", such as one of “${it.name}”" }.orEmpty()
            problems.add(
                ProblemKind.WILD_TIMES,
                "Records with impossible times, or days away from all others$example, were dropped${timesText(entries.wildCount + far)}.",
                count = entries.wildCount + far,
                loss = Loss(cells = entries.wildCount + far),
            )
        }
    }

    internal companion object {
        /** The text that badlog's own writer puts in the header, which is not worth showing. */
        const val OWN_HEADER = "{\"writer\":\"badlog\"}"

        /** A hundred entries of 1,000 samples a second for eight minutes. */
        private const val MAX_RECORDS = 50_000_000

        /** After this many bytes, it checks whether there are too many records. */
        private const val PIECE = 1 shl 20

        /** The maximum number of entries listed in a message. */
        private const val NAMED = 8
    }
}
