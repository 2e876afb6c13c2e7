package badlog.formats.wpilog.record

import badlog.core.analysis.Span
import badlog.core.recording.Topic
import badlog.core.recording.Value
import badlog.formats.wpilog.ControlKind
import badlog.formats.wpilog.RecordBuffer
import badlog.formats.wpilog.VALUE_METADATA
import badlog.formats.wpilog.WpilogEntries
import badlog.formats.wpilog.WpilogParser
import badlog.formats.wpilog.metadataOf
import kotlin.math.round

/**
 * Copies the records of [log], or some of them, unchanged.
 *
 * @param progress called after each piece with the number of records done so far, and the total. An exception from it stops the writing and
 *   is passed on.
 * @param sink receives the file in pieces of about 64 KiB, each `[0, size)` of the array, which is reused after the call. An
 *   exception from it stops the writing and is passed on.
 */
public class RecordCopy(
    private val log: RecordLog,
    private val progress: (done: Long, total: Long) -> Unit = { _, _ -> },
    private val sink: (bytes: ByteArray, size: Int) -> Unit,
) {
    /** A record that is repeated, at another time, before the record [place]. */
    private class HeldValue(val record: Int, val micros: Double, val place: Int)

    private val store = log.store
    private val out = RecordBuffer()

    /** Writes all records. */
    public fun all() {
        write(BooleanArray(store.size) { true })
        flush()
    }

    /**
     * Writes the records that differ from the previous one of their entry.
     *
     * @param isEvent whether the records of an entry are events, rather than values that hold until the next.
     * @return the number of skipped records.
     */
    public fun changes(isEvent: (RecordEntry) -> Boolean): Int {
        val isKept = BooleanArray(store.size) { true }
        var repeats = 0
        for (entry in log.entries) {
            if (isEvent(entry)) continue
            val records = entry.records
            for (i in 1 until records.size) {
                if (!store.isSame(records[i - 1], store, records[i])) continue
                isKept[records[i]] = false
                repeats++
            }
        }
        write(isKept)
        flush()
        return repeats
    }

    /**
     * Writes the records within [spans], which are in s, ascend, and do not touch. At the start of each span, the last previous record of
     * each entry is repeated, since it holds there. All control records are kept. Facts about the run, such as the match, are written as
     * values if the part would lack them, and so are [values], replacing those with the same names.
     *
     * @param isEvent whether the records of an entry are events rather than values that hold, so that none is repeated.
     * @param described returns a topic with a new unit and attributes for an entry, or null.
     */
    public fun spans(
        spans: List<Span>,
        isEvent: (RecordEntry) -> Boolean,
        values: List<Value> = emptyList(),
        described: (RecordEntry) -> Topic? = { null },
    ) {
        val isKept = BooleanArray(store.size) { store.isControl(it) }
        val begins = IntArray(spans.size) { store.size }
        var first = spans.firstOrNull()?.let { microsOf(it.from) } ?: 0.0
        for (entry in log.entries) {
            for ((index, span) in spans.withIndex()) {
                for (i in firstAt(entry, span.from) until firstAfter(entry, span.to)) {
                    val record = entry.records[i]
                    isKept[record] = true
                    begins[index] = minOf(begins[index], record)
                    first = minOf(first, log.micros(record))
                }
            }
        }
        val replaced = log.entries.filter { entry -> entry.isValue && values.any { it.name == entry.name } }
        for (entry in replaced) for (record in entry.records + entry.controls) isKept[record] = false
        val held = log.entries.filter { !it.isSystemTime && !isEvent(it) && it !in replaced }.flatMap { entry ->
            // Once is enough for something that never changes.
            val where = if (entry.isValue) spans.take(1) else spans
            where.mapIndexedNotNull { index, span -> heldIn(entry, span, begins[index]) }
        }
        val rewritten = log.entries.mapIndexedNotNull { index, entry -> described(entry)?.let { index to metadataOf(it) } }.toMap()
        val written = WpilogParser(keepSamples = false)
        write(isKept, held, rewritten) { written.accept(out.bytes, 0, out.size) }
        written.accept(out.bytes, 0, out.size)
        val present = written.finish().values.mapTo(HashSet()) { it.name }
        var id = 0
        for (value in values + log.valuesAt(first).filter { own -> values.none { it.name == own.name } }) {
            if (value.name in present) continue
            id = store.freeId(id + 1)
            out.start(id, value.name, "string", VALUE_METADATA, first)
            out.string(id, first, value.text.encodeToByteArray())
        }
        flush()
    }

    /**
     * Returns the record of [entry] that holds at the start of [span]. Null if the entry has a record at that moment, or none before it. [begin] is
     * the span's first record in the file.
     */
    private fun heldIn(entry: RecordEntry, span: Span, begin: Int): HeldValue? {
        val micros = microsOf(span.from)
        val next = firstAt(entry, span.from)
        val isThere = next < firstAfter(entry, span.to) && log.micros(entry.records[next]) <= micros
        if (next == 0 || isThere) return null
        val record = entry.records[next - 1]
        // By then, its id may belong to another entry.
        val isValid = begin > record && store.sessionEnd(record) > begin
        return HeldValue(record, micros, if (isValid) begin else record + 1)
    }

    /** Returns the time in the file, in µs, for [seconds] from time 0 of the recording. */
    private fun microsOf(seconds: Double) = round(seconds * WpilogEntries.MICROS) + log.origin

    private fun firstAt(entry: RecordEntry, seconds: Double) = firstWhere(entry) { it >= seconds }

    private fun firstAfter(entry: RecordEntry, seconds: Double) = firstWhere(entry) { it > seconds }

    private inline fun firstWhere(entry: RecordEntry, isThere: (Double) -> Boolean): Int {
        var low = 0
        var high = entry.size
        while (low < high) {
            val middle = (low + high) ushr 1
            if (isThere(entry.time(middle))) high = middle else low = middle + 1
        }
        return low
    }

    /**
     * Writes the header, the records for which [isKept] is true, and [held] ones between them. The last piece
     * stays in [out].
     *
     * @param metadata for some entries, metadata that replace those in the file.
     * @param onPiece called for each piece.
     */
    private fun write(
        isKept: BooleanArray,
        held: List<HeldValue> = emptyList(),
        metadata: Map<Int, String> = emptyMap(),
        onPiece: () -> Unit = {},
    ) {
        out.copy(log.header, 0, log.header.size)
        val waiting = ArrayDeque(held.sortedBy { it.place })
        for (index in 0..store.size) {
            while (waiting.isNotEmpty() && waiting.first().place == index) {
                waiting.removeFirst().let { store.copy(it.record, store.id(it.record), it.micros, out) }
            }
            if (index == store.size) break
            if (isKept[index] && !store.isDropped(index)) copy(index, metadata)
            if (out.size < PIECE) continue
            onPiece()
            flush()
            progress(index.toLong(), store.size.toLong())
        }
    }

    private fun copy(index: Int, metadata: Map<Int, String>) {
        val rewritten = if (store.isControl(index)) metadata[store.entry(index)] else null
        if (rewritten == null || store.controlKind(index) == ControlKind.FINISH) return store.copy(index, out)
        if (store.controlKind(index) == ControlKind.SET_METADATA) return
        val entry = log.entries[store.entry(index)]
        out.start(store.id(index), entry.name, entry.type, rewritten, store.micros(index))
    }

    private fun flush() {
        if (out.size > 0) sink(out.bytes, out.size)
        out.clear()
    }
}

private const val PIECE = 1 shl 16
