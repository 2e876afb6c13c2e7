package badlog.formats.wpilog.record

import badlog.core.analysis.stableOrder
import badlog.core.recording.Topic
import badlog.formats.wpilog.ControlKind
import badlog.formats.wpilog.RecordBuffer
import badlog.formats.wpilog.WpilogParser
import badlog.formats.wpilog.intAt
import badlog.formats.wpilog.metadataOf

/**
 * The records of [entry], all of them delayed by [offsetMicros]. If that is 0, a log with times since 1970 keeps its own clock. Otherwise the
 * recordings of all logs have the same time 0.
 */
public class RecordPiece(public val entry: RecordEntry, public val offsetMicros: Double = 0.0)

/**
 * An entry of a merged log: its [name], and the [pieces] with its records, all of the same type.
 *
 * @property described a topic with the entry's unit and attributes, if its old name implied them; otherwise null.
 */
public class MergedEntry(public val name: String, public val pieces: List<RecordPiece>, public val described: Topic? = null)

/**
 * Writes a WPILOG that has all records of [entries] in the order of time. Their payloads are copied unchanged; at equal times, the records of the
 * earlier piece come first. A record that several pieces of an entry have, with the same time and payload, is written once.
 *
 * An entry is defined by its first piece. If it has no other, its metadata and its end are also written at their times.
 */
public class RecordMerge(private val entries: List<MergedEntry>) {
    private val out = RecordBuffer()
    private val merged = IntList()
    private val piece = IntList()
    private val record = IntList()
    private val times = ArrayList<DoubleArray>()

    private val repeats = IntArray(entries.size)

    // Time 0 of the merged log.
    private val origin =
        entries.asSequence().flatMap { it.pieces }.filter { it.offsetMicros == 0.0 }.map { it.entry.log.origin }.find { it > 0 } ?: 0.0

    /** For each entry, the number of records skipped because another piece also has them. */
    public val repeated: List<Int> get() = repeats.asList()

    /**
     * Writes the merged log. Call it once.
     *
     * @param progress called after each piece with the number of records done so far, and the total. An exception from it stops the writing
     *   and is passed on.
     * @param sink receives the file in pieces of about 64 KiB, each `[0, size)` of the array, which is reused after the call. An
     *   exception from it stops the writing and is passed on.
     */
    public fun write(progress: (done: Long, total: Long) -> Unit = { _, _ -> }, sink: (bytes: ByteArray, size: Int) -> Unit) {
        val headers = entries.flatMap { it.pieces }.map { it.entry.log.header }
        val header = headers.firstOrNull()?.takeIf { first -> headers.all { it.contentEquals(first) } }
        if (header == null) out.header(WpilogParser.OWN_HEADER) else out.copy(header, 0, header.size)
        entries.forEachIndexed { index, merged ->
            start(index + 1, merged)
            append(index, merged)
        }
        val all = DoubleArray(record.size)
        var at = 0
        for (some in times) {
            some.copyInto(all, at)
            at += some.size
        }
        val order = stableOrder(all)
        for (i in order.indices) {
            val from = entries[merged[order[i]]].pieces[piece[order[i]]]
            copy(merged[order[i]] + 1, from, record[order[i]], all[order[i]])
            if (out.size < PIECE && i < order.lastIndex) continue
            sink(out.bytes, out.size)
            out.clear()
            progress(i + 1L, order.size.toLong())
        }
        if (out.size > 0) sink(out.bytes, out.size)
    }

    private fun start(id: Int, merged: MergedEntry) {
        val first = merged.pieces.first()
        val entry = first.entry
        val begin = entry.controls.firstOrNull { entry.log.store.controlKind(it) == ControlKind.START }
        val metadata = when {
            merged.described != null -> metadataOf(merged.described.copy(name = merged.name))
            merged.pieces.size > 1 || begin == null -> entry.metadata
            else -> startMetadata(entry.log.store.payload(begin))
        }
        val micros = begin?.let { entry.log.store.micros(it) + later(first) } ?: 0.0
        out.start(id, merged.name, entry.type, metadata, maxOf(0.0, micros))
    }

    /** Returns the last of the three texts in [payload], each after its length. */
    private fun startMetadata(payload: ByteArray): String {
        var at = 1 + Int.SIZE_BYTES
        repeat(2) { at += Int.SIZE_BYTES + intAt(payload, at) }
        return payload.decodeToString(at + Int.SIZE_BYTES)
    }

    /** Sorts the records of [merged], including the control records of its only piece. */
    private fun append(index: Int, merged: MergedEntry) {
        val pieces = merged.pieces
        val next = IntArray(pieces.size)
        val kept = DoubleArray(pieces.sumOf { it.entry.size + it.entry.controls.size })
        var size = 0
        while (true) {
            val from = earliest(pieces, next)
            if (from < 0) break
            val entry = pieces[from].entry
            val current = entry.records[next[from]++]
            val micros = micros(pieces[from], current)
            add(index, from, current)
            kept[size++] = micros
            for ((other, twin) in pieces.withIndex()) {
                if (other == from || next[other] == twin.entry.size) continue
                val candidate = twin.entry.records[next[other]]
                if (micros(twin, candidate) != micros || !entry.log.store.isSame(current, twin.entry.log.store, candidate)) continue
                next[other]++
                repeats[index]++
            }
        }
        val last = if (size > 0) kept[size - 1] else 0.0
        val only = pieces.singleOrNull()
        for (control in if (only == null || merged.described != null) IntArray(0) else only.entry.controls) {
            val kind = checkNotNull(only).entry.log.store.controlKind(control)
            val isEnd = kind == ControlKind.FINISH && control == only.entry.controls.last()
            if (kind != ControlKind.SET_METADATA && !isEnd) continue
            add(index, 0, control)
            // Records after an entry's end are not read, so the end is not before the last record.
            kept[size++] = maxOf(only.entry.log.store.micros(control) + later(only), if (isEnd) last else 0.0)
        }
        times += kept.copyOf(size)
    }

    private fun earliest(pieces: List<RecordPiece>, next: IntArray): Int {
        var best = -1
        var bestMicros = 0.0
        for (piece in pieces.indices) {
            if (next[piece] == pieces[piece].entry.size) continue
            val micros = micros(pieces[piece], pieces[piece].entry.records[next[piece]])
            if (best >= 0 && micros >= bestMicros) continue
            best = piece
            bestMicros = micros
        }
        return best
    }

    private fun add(index: Int, from: Int, current: Int) {
        merged.add(index)
        piece.add(from)
        record.add(current)
    }

    private fun micros(piece: RecordPiece, record: Int) = piece.entry.log.micros(record) + later(piece)

    /** Returns how much later the records of [piece] are here than in their file, in µs. */
    private fun later(piece: RecordPiece): Double {
        val own = piece.entry.log.origin
        return if (own > 0 && piece.offsetMicros == 0.0) 0.0 else origin - own + piece.offsetMicros
    }

    private fun copy(id: Int, from: RecordPiece, index: Int, micros: Double) {
        val store = from.entry.log.store
        if (!store.isControl(index)) return store.copy(index, id, micros, out)
        val payload = store.payload(index)
        for (i in 0 until Int.SIZE_BYTES) payload[1 + i] = (id ushr 8 * i).toByte()
        out.record(0, micros, payload, 0, payload.size)
    }
}

private const val PIECE = 1 shl 16
