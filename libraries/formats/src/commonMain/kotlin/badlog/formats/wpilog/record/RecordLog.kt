package badlog.formats.wpilog.record

import badlog.core.analysis.stableOrder
import badlog.core.recording.ProblemList
import badlog.core.recording.Value
import badlog.core.text.originOf
import badlog.formats.column.ColumnSource
import badlog.formats.wpilog.ControlKind
import badlog.formats.wpilog.Entry
import badlog.formats.wpilog.MatchMetadata
import badlog.formats.wpilog.RecordHead
import badlog.formats.wpilog.RecordSink
import badlog.formats.wpilog.RecordSplitter
import badlog.formats.wpilog.TimeHistogram
import badlog.formats.wpilog.WpilogEntries
import badlog.formats.wpilog.intAt

/**
 * The records of a WPILOG, byte for byte as in its file, for programs that copy them. Records that the parser drops are not
 * included: those without an entry, of a wrong size, or at impossible times.
 *
 * All of it is in memory: the file's bytes, and about 30 more for each record.
 *
 * @property entries its entries, in the order in which they were first started.
 */
public class RecordLog internal constructor(
    internal val header: ByteArray,
    public val entries: List<RecordEntry>,
    internal val store: RecordStore,
    private val match: MatchMetadata,
    private val firstMicros: Double,
) {
    /** Time 0 of its recording, in µs on the file's clock. It is more than 0 if its records have times since 1970. */
    internal val origin: Double = originOf(firstMicros)

    /** Returns the time from which record [index] holds, in µs on the file's clock. A record before 0 holds from the start of the log. */
    internal fun micros(index: Int): Double = store.micros(index).let { if (it < 0) firstMicros else it }

    /** Returns the facts about its run, as if it began at [micros] on the file's clock. */
    internal fun valuesAt(micros: Double): List<Value> = match.values(micros)

    /** Reads the inflated bytes of a WPILOG, and keeps its records. Not thread-safe. */
    public class Reader {
        private val keeper = RecordKeeper()
        private val splitter = RecordSplitter(keeper)

        /** Accepts the next bytes, from [from] until [until] of [bytes]. Keeps no reference to the array. */
        public fun accept(bytes: ByteArray, from: Int = 0, until: Int = bytes.size): Unit = splitter.accept(bytes, from, until)

        /** Returns the records. Call it once, last. */
        public fun finish(): RecordLog {
            splitter.finish()
            return keeper.finish()
        }
    }
}

/**
 * An entry of a WPILOG: all records of one name and type, under however many ids it was started.
 *
 * @property metadata its last metadata in the file.
 * @property isValue whether it is a value written by badlog, rather than a topic.
 */
public class RecordEntry internal constructor(
    public val name: String,
    public val type: String,
    public val metadata: String,
    public val isValue: Boolean,
    private val logOf: () -> RecordLog,
    internal val records: IntArray,
    internal val controls: IntArray,
) {
    /** The number of its records. */
    public val size: Int get() = records.size

    internal val log: RecordLog get() = logOf()

    /** Whether it has the time of day, which is only correct at the original times of its records. */
    internal val isSystemTime: Boolean get() = name == Entry.SYSTEM_TIME

    /** Returns the time from which its record [index] holds, in s from time 0 of the recording. Times ascend. */
    public fun time(index: Int): Double = (log.micros(records[index]) - log.origin) / WpilogEntries.MICROS

    /** Returns the bytes of record [index]. */
    public fun payload(index: Int): ByteArray = log.store.payload(records[index])
}

/** Keeps the records that [WpilogEntries] reads. */
private class RecordKeeper : RecordSink {
    private val entries = WpilogEntries(ColumnSource(keepsSamples = false), ProblemList())
    private val store = RecordStore()
    private val places = LinkedHashMap<Entry, Int>()
    private val sessionOf = HashMap<Int, Int>()
    private var header = ByteArray(0)

    override fun header(bytes: ByteArray, from: Int, until: Int): Boolean {
        header = bytes.copyOfRange(from, until)
        return entries.header(bytes, from, until)
    }

    override fun entryOf(id: Int): Entry? = entries.entryOf(id)

    override fun isStranger(id: Int): Boolean = entries.isStranger(id)

    override fun skipped(from: Long, until: Long) = Unit

    override fun record(head: RecordHead, position: Long, bytes: ByteArray, from: Int, until: Int) {
        if (!entries.read(head, bytes, until)) return
        val payload = until - head.size
        val isControl = head.id == 0
        val subject = if (isControl) intAt(bytes, payload + 1) else head.id
        if (isControl && bytes[payload].toInt() == ControlKind.START) begin(subject)
        val session = sessionOf[subject] ?: return
        store.add(bytes, from, payload, until, head.micros, session, isControl)
        if (isControl && bytes[payload].toInt() == ControlKind.FINISH) end(subject)
    }

    private fun begin(id: Int) {
        end(id)
        val entry = checkNotNull(entries.entryOf(id))
        sessionOf[id] = store.begin(id, places.getOrPut(entry) { places.size })
    }

    private fun end(id: Int) {
        sessionOf.remove(id)?.let(store::end)
    }

    fun finish(): RecordLog {
        entries.finish()
        val cluster = entries.histogram.largestCluster() ?: TimeHistogram.Cluster(0.0, 1.0, 0.0)
        val all = places.keys.toList()
        val records = List(all.size) { IntList() }
        val controls = List(all.size) { IntList() }
        for (index in 0 until store.size) {
            val place = store.entry(index)
            val micros = store.micros(index)
            when {
                store.isControl(index) -> controls[place].add(index)
                micros >= 0 && (micros < cluster.from || micros >= cluster.until) -> store.drop(index)
                !store.fits(index, all[place].decoder) -> store.drop(index)
                else -> records[place].add(index)
            }
        }
        lateinit var log: RecordLog
        val described = all.mapIndexed { place, entry ->
            val ordered = inOrder(records[place].toArray())
            RecordEntry(entry.name, entry.type, entry.metadata, entry.isValue, { log }, ordered, controls[place].toArray())
        }
        log = RecordLog(header, described, store, entries.match, cluster.from)
        return log
    }

    /** Returns [records] in the order of their times; for equal times, in the order of the file. */
    private fun inOrder(records: IntArray): IntArray {
        if ((1 until records.size).all { store.micros(records[it - 1]) <= store.micros(records[it]) }) return records
        val order = stableOrder(DoubleArray(records.size) { store.micros(records[it]) })
        return IntArray(records.size) { records[order[it]] }
    }
}
