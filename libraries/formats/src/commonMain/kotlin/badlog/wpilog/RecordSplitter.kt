package badlog.wpilog

/** Takes what a [RecordSplitter] finds. */
internal interface RecordSink {
    /** The twelve bytes of the header at [from] and the text after them, up to [until]; false when this is not a WPILOG. */
    fun header(bytes: ByteArray, from: Int, until: Int): Boolean

    /** The entry that has the number [id] now, or null. */
    fun entryOf(id: Int): Entry?

    /** Whether there were so many records of [id], which is no entry's number, that more are to be expected. */
    fun isStranger(id: Int): Boolean

    /** A record, whose bytes from [from] until [until] begin at [position] in the file. */
    fun record(head: RecordHead, position: Long, bytes: ByteArray, from: Int, until: Int)

    /** The bytes of the file from [from] until [until] are not records; those after them are. */
    fun skipped(from: Long, until: Long)
}

/**
 * Cuts bytes that arrive in pieces into the records of a WPILOG, and finds them again after damage. Holds what has arrived of one
 * record, and about a megabyte where it is not sure.
 *
 * A record is passed on when the next one looks like one, too: a wrong size is found out where the record ends.
 */
internal class RecordSplitter(private val sink: RecordSink) {
    private val search = RecordSearch(sink)
    private var held = ByteArray(0)
    private var heldSize = 0
    private var isRefused = false

    // What is read next, and what stands behind it.
    private var head = RecordHead()
    private var nextHead = RecordHead()
    private var lastMicros = Double.NaN

    // The last time that was near the one before: damage may bring any other.
    private var steadyMicros = Double.NaN

    // The size of a payload that nobody wonders at.
    private var usualSize = SMALL

    // Where in the file the first byte of the array stands that is being read.
    private var base = 0L

    // Where in the file the damage began, while the records after it are searched for.
    private var gapFrom = -1L

    // In what follows the place searchedFor, records go on nowhere before searchedUntil.
    private var searchedFor = -1L
    private var searchedUntil = -1L

    /** How many bytes have arrived. */
    var total = 0L
        private set

    /** From which byte on nothing can be read; -1 when all could be. To be asked after [finish], as what follows. */
    val readableEnd: Long get() = gapFrom

    /** How many bytes of a record are there that is not whole. */
    var pendingBytes = 0
        private set

    /** Whether the header has been read. */
    var isPastHeader = false
        private set

    /** Whether a header may have begun that is not whole. */
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
            // What is left may be read where it is instead of being copied.
            if (left <= size) at -= left else held.copyInto(held, 0, heldSize - left, heldSize)
            heldSize = if (left <= size) 0 else left
        }
    }

    /** Says that no more bytes come. */
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

    /** Reads what can be read of the bytes; returns where the rest begins. */
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

                // What a control record says is needed to know the next one.
                head.id == 0 || (isEnd && head.length == until - at) -> pass(bytes, at)

                else -> {
                    val end = at + head.length
                    val nextLook = search.look(nextHead, bytes, end, until, head.micros)
                    isKnown = nextLook == RecordLook.FITTING
                    // A small odd record is looked at whole.
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
     * Passes on the record at [from], whose [head] fits, and those behind it, up to one that anything is odd about; returns where that
     * one begins, whose head [head] is then. Nearly all records of a log pass here: what is rare stays outside of this loop.
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

    /** A record that fits, but is larger than usual or stands before something that does not fit: its own size may be wrong. */
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
        // A hole of zeros that begins inside a record leaves its head.
        val isTorn = nextLook == RecordLook.NONE && bytes[end].toInt() == 0 && bytes[end - 1].toInt() == 0
        if (!isTorn) return pass(bytes, at)
        gapFrom = base + at
        return end
    }

    /** What does not fit. */
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

    /** A record that the file ends in, or whose size is damaged. */
    private fun readCut(bytes: ByteArray, at: Int, until: Int): Int {
        val found = find(bytes, at, until, until, true)
        return if (found >= 0) skip(at, found) else cut(at, until)
    }

    private fun cut(at: Int, until: Int): Int {
        pendingBytes = until - at
        return until
    }

    /** Where records go on behind [at] and before [end]; as [RecordSearch.find] has it. */
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
        /** How each WPILOG begins. */
        const val MAGIC = "WPILOG"

        /** The header without its text. */
        const val HEADER = 12
        private const val WAIT = -1

        /** An odd record that is no larger may take a few others with it. */
        private const val SMALL = 1000

        /** So much of what arrives is put behind what is held. */
        private const val STEP = 1 shl 12
    }
}
