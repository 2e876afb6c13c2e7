package badlog.formats.wpilog

/** Receives the results of a [RecordSplitter]. */
internal interface RecordSink {
    /** Receives the twelve bytes of the header at [from] and the text after them, up to [until]. Returns false if this is not a WPILOG. */
    fun header(bytes: ByteArray, from: Int, until: Int): Boolean

    /** Returns the entry that currently has the id [id], or null. */
    fun entryOf(id: Int): Entry?

    /** Returns whether [id], which belongs to no entry, had so many records that more are likely. */
    fun isStranger(id: Int): Boolean

    /** Receives the record from [from] until [until] of [bytes], which begins at [position] in the file. */
    fun record(head: RecordHead, position: Long, bytes: ByteArray, from: Int, until: Int)

    /** Called if the bytes of the file from [from] until [until] are not records, but those after them are. */
    fun skipped(from: Long, until: Long)
}

/**
 * Splits bytes that arrive in pieces into the records of a WPILOG, and finds records again after damage. Holds the received part
 * of one record, and about a megabyte in doubtful cases.
 *
 * A record is passed on when the next one also looks like a record: a wrong size is discovered where the record ends.
 */
internal class RecordSplitter(private val sink: RecordSink) {
    private val search = RecordSearch(sink)
    private var held = ByteArray(0)
    private var heldSize = 0
    private var isRefused = false

    // The heads of the next record and of the one after it.
    private var head = RecordHead()
    private var nextHead = RecordHead()
    private var lastMicros = Double.NaN

    // The last time that was near its predecessor: damage may contain any time.
    private var steadyMicros = Double.NaN

    // The largest size of an unsuspicious payload.
    private var usualSize = SMALL

    // The position in the file of the first byte of the array that is being read.
    private var base = 0L

    // The position of the damage in the file while the records after it are searched; otherwise -1.
    private var gapFrom = -1L

    // After the place searchedFor, records do not continue anywhere before searchedUntil.
    private var searchedFor = -1L
    private var searchedUntil = -1L

    /** The number of bytes received. */
    var total = 0L
        private set

    /** The position from which nothing can be read; -1 if everything could be read. Valid after [finish], like the following properties. */
    val readableEnd: Long get() = gapFrom

    /** The number of bytes of an incomplete record. */
    var pendingBytes = 0
        private set

    /** Whether the header has been read. */
    var isPastHeader = false
        private set

    /** Whether there may be an incomplete header. */
    val isInHeader: Boolean
        get() = !isPastHeader && !isRefused && MAGIC.indices.all { it >= heldSize || held[it].toInt() == MAGIC[it].code }

    fun accept(bytes: ByteArray, from: Int, until: Int) {
        total += until - from
        var at = from
        while (at < until && !isRefused) {
            if (heldSize == 0) {
                base = total - until
                hold(bytes, read(bytes, at, until, false), until)
                return
            }
            val size = minOf(until - at, STEP)
            hold(bytes, at, at + size)
            at += size
            base = total - (until - at) - heldSize
            val left = heldSize - read(held, 0, heldSize, false)
            // The rest can be read in place instead of being copied.
            if (left <= size) at -= left else held.copyInto(held, 0, heldSize - left, heldSize)
            heldSize = if (left <= size) 0 else left
        }
    }

    /** Marks the end of the bytes. */
    fun finish() {
        base = total - heldSize
        if (!isInHeader && !isRefused) read(held, 0, heldSize, true) else pendingBytes = heldSize
    }

    private fun hold(bytes: ByteArray, from: Int, until: Int) {
        val size = heldSize + until - from
        if (size > held.size) held = held.copyOf(maxOf(64, size, minOf(size * 2L, RecordHead.MAX_PAYLOAD_BYTES * 2L).toInt()))
        bytes.copyInto(held, heldSize, from, until)
        heldSize = size
    }

    /** Reads as many of the bytes as possible. Returns where the rest begins. */
    private fun read(bytes: ByteArray, from: Int, until: Int, isEnd: Boolean): Int {
        var at = if (isPastHeader) from else readHeader(bytes, from, until)
        if (!isPastHeader || isRefused) return at
        // Whether [head] is known to fit.
        var isKnown = false
        while (at < until) {
            if (isKnown) {
                at = passFitting(bytes, at, until)
                if (at == until) break
            }
            if (gapFrom >= 0) {
                val found = search.find(bytes, at, Int.MAX_VALUE, until, isEnd, steadyMicros, isInside = false)
                if (found < 0) return if (found == RecordSearch.NOWHERE) until else RecordSearch.waitsAt(found)
                at = endGap(found)
            }
            val look = if (isKnown) RecordLook.FITTING else search.look(head, bytes, at, until, lastMicros)
            isKnown = false
            val next = when {
                look == RecordLook.MORE || (look == RecordLook.FITTING && head.length > until - at) ->
                    if (isEnd) readCut(bytes, at, until) else WAIT

                look != RecordLook.FITTING -> readOdd(bytes, at, until, look, isEnd)

                // The content of a control record is needed to recognize the next record.
                head.id == 0 || (isEnd && head.length == until - at) -> pass(bytes, at)

                else -> {
                    val end = at + head.length
                    val nextLook = search.look(nextHead, bytes, end, until, head.micros)
                    isKnown = nextLook == RecordLook.FITTING
                    // A small odd record is examined as a whole.
                    val isPartly = nextLook == RecordLook.ODD && nextHead.length in until - end + 1..SMALL
                    when {
                        !isEnd && (isPartly || nextLook == RecordLook.MORE) -> WAIT
                        isKnown && head.size <= usualSize -> pass(bytes, at)
                        else -> readDoubtful(bytes, at, until, nextLook, isEnd).also { if (it != end) isKnown = false }
                    }
                }
            }
            if (next == WAIT) return at
            if (isKnown) head = nextHead.also { nextHead = head }
            at = next
        }
        return at
    }

    /**
     * Passes on the fitting record at [from] and those after it, up to one that is odd. Returns where that one begins; [head] is then its head.
     * Nearly all records of a log are handled here, so rare cases stay outside this loop.
     */
    private fun passFitting(bytes: ByteArray, from: Int, until: Int): Int {
        var at = from
        var one = head
        var other = nextHead
        while (one.id != 0 && one.size <= usualSize && one.length < until - at) {
            val end = at + one.length
            if (search.look(other, bytes, end, until, one.micros) != RecordLook.FITTING) break
            sink.record(one, base + at, bytes, at, end)
            steadyMicros = one.micros
            one = other.also { other = one }
            at = end
        }
        if (at > from) lastMicros = steadyMicros
        head = one
        nextHead = other
        return at
    }

    private fun pass(bytes: ByteArray, at: Int, isSteady: Boolean = true): Int {
        val end = at + head.length
        sink.record(head, base + at, bytes, at, end)
        if (head.id != 0) {
            if (isSteady) steadyMicros = head.micros
            lastMicros = head.micros
        }
        return end
    }

    /** Reads a record that fits, but is unusually large, or followed by something that does not fit. Its own size may be wrong. */
    private fun readDoubtful(bytes: ByteArray, at: Int, until: Int, nextLook: RecordLook, isEnd: Boolean): Int {
        val end = at + head.length
        if (!head.hasOneSize) {
            if (nextLook == RecordLook.ODD && nextHead.length <= minOf(SMALL, until - end)) {
                val fitting = search.allFit(bytes, end + nextHead.length, until, isEnd)
                if (fitting == RecordLook.MORE) return WAIT
                if (fitting == RecordLook.FITTING) return pass(bytes, at)
            }
            val found = find(bytes, at, end, until, isEnd)
            if (found >= 0) return skip(at, found)
            if (found != RecordSearch.NOWHERE) return WAIT
        }
        usualSize = maxOf(usualSize, head.size * 2)
        // A hole of zeros that begins inside a record leaves its head intact.
        val isTorn = nextLook == RecordLook.NONE && bytes[end].toInt() == 0 && bytes[end - 1].toInt() == 0
        if (!isTorn) return pass(bytes, at)
        gapFrom = base + at
        return end
    }

    /** Reads something that does not fit. */
    private fun readOdd(bytes: ByteArray, at: Int, until: Int, look: RecordLook, isEnd: Boolean): Int {
        if (look == RecordLook.ODD) {
            val end = at + head.length
            if (head.length <= SMALL && (!isEnd || end <= until)) {
                if (end > until) return WAIT
                val fitting = search.allFit(bytes, end, until, isEnd)
                if (fitting == RecordLook.FITTING) return pass(bytes, at, isSteady = false)
                if (fitting == RecordLook.MORE) return WAIT
            }
            val found = find(bytes, at, end, until, isEnd)
            if (found >= 0) return skip(at, found)
            if (found != RecordSearch.NOWHERE) return WAIT
            if (head.length > until - at) return cut(at, until)
            val after = search.goesOn(bytes, end, until, isEnd)
            if (after == RecordLook.MORE) return WAIT
            if (after == RecordLook.FITTING) return pass(bytes, at, isSteady = false)
        }
        gapFrom = base + at
        return at + 1
    }

    /** Reads a record that the end of the file cuts off, or that has a damaged size. */
    private fun readCut(bytes: ByteArray, at: Int, until: Int): Int {
        val found = find(bytes, at, until, until, true)
        return if (found >= 0) skip(at, found) else cut(at, until)
    }

    private fun cut(at: Int, until: Int): Int {
        pendingBytes = until - at
        return until
    }

    /** Returns where records continue after [at] and before [end], see [RecordSearch.find]. */
    private fun find(bytes: ByteArray, at: Int, end: Int, until: Int, isEnd: Boolean): Int {
        val place = base + at
        val from = if (searchedFor == place) (searchedUntil - base).toInt() else at + 1
        val found = search.find(bytes, from, end, until, isEnd, steadyMicros, isInside = true)
        searchedFor = place
        searchedUntil = base + if (found < RecordSearch.NOWHERE) RecordSearch.waitsAt(found) else minOf(end, until)
        return found
    }

    private fun skip(at: Int, found: Int): Int {
        gapFrom = base + at
        return endGap(found)
    }

    private fun endGap(found: Int): Int {
        sink.skipped(gapFrom, base + found)
        gapFrom = -1
        lastMicros = Double.NaN
        return found
    }

    private fun readHeader(bytes: ByteArray, from: Int, until: Int): Int {
        if (until - from < HEADER) return from
        val size = intAt(bytes, from + HEADER - Int.SIZE_BYTES)
        if (size !in 0..RecordHead.MAX_PAYLOAD_BYTES) {
            isRefused = true
            return from
        }
        if (size > until - from - HEADER) return from
        isPastHeader = true
        val end = from + HEADER + size
        isRefused = !sink.header(bytes, from, end)
        return end
    }

    companion object {
        /** The start of every WPILOG. */
        const val MAGIC = "WPILOG"

        /** The size in bytes of the header without its text. */
        const val HEADER = 12
        private const val WAIT = -1

        /** An odd record up to this size may cost a few others. */
        private const val SMALL = 1000

        /** The number of received bytes that are appended to the held ones at a time. */
        private const val STEP = 1 shl 12
    }
}
