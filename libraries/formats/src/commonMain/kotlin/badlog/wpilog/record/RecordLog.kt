package badlog.wpilog.record

import badlog.analysis.stableOrder
import badlog.column.ColumnSource
import badlog.recording.ProblemList
import badlog.recording.Value
import badlog.wpilog.ControlKind
import badlog.wpilog.Entry
import badlog.wpilog.MatchMetadata
import badlog.wpilog.RecordHead
import badlog.wpilog.RecordSink
import badlog.wpilog.RecordSplitter
import badlog.wpilog.TimeHistogram
import badlog.wpilog.WpilogEntries
import badlog.wpilog.intAt

/**
 * The records of a WPILOG, byte by byte as they stand in its file, for programs that copy them. What its parser drops is not among
 * them: records of no entry, without the bytes of their type, at times that cannot be.
 *
 * All of it is in memory: the file's bytes, and some 30 more for each record.
 *
 * @property entries what it has records of, in the order in which they were first begun.
 */
public class RecordLog internal constructor(
    internal val header: ByteArray,
    public val entries: List<RecordEntry>,
    internal val store: RecordStore,
    private val match: MatchMetadata,
    private val firstMicros: Double,
) {
    /** When record [index] holds, in µs; one from before 0 does so from the log's beginning on. */
    internal fun micros(index: Int): Double = store.micros(index).let { if (it < 0) firstMicros else it }

    /** What it would say of its run if it began at [micros]. */
    internal fun valuesAt(micros: Double): List<Value> = match.values(micros)

    /** Takes the bytes of a WPILOG, inflated, and keeps its records. Not safe for use by several threads. */
    public class Reader {
        private val keeper = RecordKeeper()
        private val splitter = RecordSplitter(keeper)

        /** Takes the bytes from [from] until [until] of [bytes], which follow those of the calls before. Keeps no reference. */
        public fun accept(bytes: ByteArray, from: Int = 0, until: Int = bytes.size): Unit = splitter.accept(bytes, from, until)

        /** What was read. To be called once, last. */
        public fun finish(): RecordLog {
            splitter.finish()
            return keeper.finish()
        }
    }
}

/**
 * What a WPILOG has records of: all of one name and one type, under however many numbers it was begun.
 *
 * @property metadata what the file says of it last.
 * @property isValue whether it is a value that badlog has written, and no topic.
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
    /** How many records it has. */
    public val size: Int get() = records.size

    internal val log: RecordLog get() = logOf()

    /** Whether it has the time of day, which is true only where it was written. */
    internal val isSystemTime: Boolean get() = name == Entry.SYSTEM_TIME

    /** When record [index] of it holds, in s. They ascend. */
    public fun time(index: Int): Double = log.micros(records[index]) / WpilogEntries.MICROS

    /** The bytes of record [index]. */
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

    /** [records] in the order of their times; of one time in that of the file. */
    private fun inOrder(records: IntArray): IntArray {
        if ((1 until records.size).all { store.micros(records[it - 1]) <= store.micros(records[it]) }) return records
        val order = stableOrder(DoubleArray(records.size) { store.micros(records[it]) })
        return IntArray(records.size) { records[order[it]] }
    }
}
