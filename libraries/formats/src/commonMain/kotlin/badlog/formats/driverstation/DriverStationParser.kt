package badlog.formats.driverstation

import badlog.core.bag.BagParser
import badlog.core.recording.CellCounts
import badlog.core.recording.LogParser
import badlog.core.recording.Loss
import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.recording.Recording
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.recording.Value
import badlog.core.recording.timesText
import badlog.core.text.wallTimeText
import badlog.formats.column.ColumnSource
import badlog.formats.column.SampleColumn
import badlog.formats.column.Timestamps
import badlog.formats.column.addCut
import badlog.formats.column.addLost
import badlog.formats.column.addSkipped
import badlog.formats.column.addTooMany
import badlog.formats.column.reportTopic

/**
 * Reads a log of the Driver Station, pushed to it in pieces of any size. The log is a `.dslog`, a `.dsevents`, or the bytes of both, in
 * this order. It never throws because of the bytes: whatever is wrong becomes a problem of the recording, by the rules in
 * `docs/driver-station.md`.
 *
 * Besides the samples, it holds a few records of the file, or an event and the bytes needed to find the next one after damage, at most 3 MB. Not
 * thread-safe.
 *
 * @param keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
 */
public class DriverStationParser(keepSamples: Boolean = true) : LogParser {
    private val source = ColumnSource(keepSamples)
    private val problems = ProblemList()
    private val splitter = FrameSplitter(::begin) { from, until, records -> problems.addSkipped(from, until, records) }
    private var records: StationRecords? = null
    private var events: StationEvents? = null
    private var refusal: String? = null

    /** The time of day at which x is 0, in whole seconds since 1904 and their fraction. Below 0 if no header was read. */
    private var seconds = -1.0
    private var fraction = 0.0

    /** The number of records and entries read so far. */
    override val rowCount: Int get() = splitter.count

    override var maxRows: Int = BagParser.MAX_ROWS

    /** A record has a dozen samples, and more if there is a power distribution. */
    private val maxRecords: Int get() = maxRows / SAMPLES

    override var isFull: Boolean = false
        private set

    override fun accept(bytes: ByteArray, from: Int, until: Int) {
        var at = from
        while (at < until && !isFull) {
            val end = minOf(at + PIECE, until)
            if (refusal == null && rowCount < maxRecords) splitter.accept(bytes, at, end) else isFull = true
            at = end
        }
    }

    /** Returns the frames after the header at [at]; null if badlog does not read its version. */
    private fun begin(bytes: ByteArray, at: Int, until: Int): Frames? {
        val version = wordAt(bytes, at)
        if (version !in VERSIONS) {
            refusal = "This Driver Station log has version $version; badlog reads versions 3 and 4 (2016 to 2026)."
            return null
        }
        val headerSeconds = secondsAt(bytes, at + Int.SIZE_BYTES)
        if (seconds < 0) {
            seconds = headerSeconds
            fraction = fractionAt(bytes, at + Int.SIZE_BYTES)
        }
        val first = at + HEADER_SIZE
        val isEvents = records != null ||
            (until - first >= Long.SIZE_BYTES && wordAt(bytes, first) == 0 && StationEvents.isNear(secondsAt(bytes, first), headerSeconds))
        return if (isEvents) {
            events ?: StationEvents(headerSeconds, seconds, fraction, source).also { events = it }
        } else {
            StationRecords(version, source).also { records = it }
        }
    }

    override fun finish(): Recording {
        if (!isFull) splitter.finish()
        refusal?.let { problems.add(ProblemKind.NOT_A_RECORDING, it) } ?: reportEnd()
        val topics = ArrayList<Topic>()
        val add = { column: SampleColumn, unit: String, attributes: List<String>, times: Timestamps ->
            times.finish(0.0..Double.MAX_VALUE)
            val like = Topic("", unit, attributes, DoubleArray(0), TextColumn.EMPTY, NO_CELLS, times.times)
            val topic = column.build(column.path, like, times)
            reportTopic(topic, column, times, problems)
            topics += topic
        }
        records?.topics(add)
        events?.topics(add)
        if (refusal == null && rowCount == 0) {
            problems.add(ProblemKind.NO_ROWS, "There are no samples; the Driver Station may have been closed too early.")
        }
        return Recording(DriverStationFormat, null, values(), topics, 0, problems.toList())
    }

    private fun values(): List<Value> {
        val start = if (seconds < 0) null else wallTimeText((seconds + fraction - SECONDS_TO_1970) * MICROS)
        return events?.match?.values().orEmpty() + listOfNotNull(start?.let { Value("Start Time", it) })
    }

    private fun reportEnd() {
        val bad = records?.badCount ?: 0
        if (bad > 0) {
            val message = "Records with all modes of the robot at once were dropped${timesText(bad)}."
            problems.add(ProblemKind.BAD_RECORD, message, count = bad, loss = Loss(cells = bad))
        }
        when {
            isFull -> problems.addTooMany(maxRecords)
            splitter.lostFrom >= 0 -> problems.addLost(splitter.lostFrom, splitter.total)
            splitter.pendingBytes > 0 -> problems.addCut(splitter.pendingBytes)
        }
    }

    private companion object {
        val VERSIONS = 3..4

        const val SAMPLES = 12

        /** The number of bytes after which the number of records is checked. */
        const val PIECE = 1 shl 16
        const val MICROS = 1e6
        val NO_CELLS = CellCounts(0, 0, 0, 0, 0, 0)
    }
}
