package badlog.wpilog

/** What became of a record. */
internal enum class RecordFate {
    /** It was read. */
    READ,

    /** It belongs to no entry: an odd record, or bytes that only look like one. */
    UNKNOWN,

    /** It cannot be a record; nothing after it can be trusted. */
    NONSENSE,
}

/** Takes what a [RecordSplitter] finds. */
internal interface RecordSink {
    /** The twelve bytes of the header at [from] and the text after them, up to [until]; false when this is not a WPILOG. */
    fun header(bytes: ByteArray, from: Int, until: Int): Boolean

    /** A record of entry [id] at [micros], which begins at [head] and has its payload from [from] until [until]. */
    fun record(id: Int, micros: Double, bytes: ByteArray, head: Int, from: Int, until: Int): RecordFate
}

/** Cuts bytes that arrive in pieces into the records of a WPILOG. Holds one record at most, and only what has arrived. */
internal class RecordSplitter(private val sink: RecordSink) {
    private var held = ByteArray(0)
    private var heldSize = 0
    private var sawHeader = false
    private var doubtfulFrom = 0L
    private var doubtful = 0

    // Where the next record begins.
    private var position = 0L

    /** How many bytes have arrived. */
    var total = 0L
        private set

    /** From which byte on nothing can be read; -1 when all could be. */
    var readableEnd = -1L
        private set

    /** How many records before the nonsense, [RecordFate.UNKNOWN] all of them, are taken for nonsense too. */
    var recordsInNonsense = 0
        private set

    /** How many bytes of a record are there that is not whole. */
    val pendingBytes: Int get() = heldSize

    /** Whether the header has been read. */
    val isPastHeader: Boolean get() = sawHeader

    /** Whether a header may have begun that is not whole. */
    val isInHeader: Boolean
        get() = !sawHeader && readableEnd < 0 && MAGIC.indices.all { it >= heldSize || held[it].toInt() == MAGIC[it].code }

    fun accept(bytes: ByteArray, from: Int, until: Int) {
        total += until - from
        var at = completeHeld(bytes, from, until)
        while (at < until && readableEnd < 0) {
            val length = lengthOf(bytes, at, until - at)
            if (length > until - at) break
            if (length == NONE || !deliver(bytes, at, at + length)) return stop()
            at += length
        }
        if (readableEnd < 0) hold(bytes, at, until)
    }

    /** Adds to what is held until it is a record; returns where the next one begins. */
    private fun completeHeld(bytes: ByteArray, from: Int, until: Int): Int {
        var at = from
        while (heldSize > 0 && readableEnd < 0) {
            val length = lengthOf(held, 0, heldSize)
            if (length == heldSize) {
                if (!deliver(held, 0, heldSize)) stop()
                heldSize = 0
            } else if (length == NONE) {
                stop()
            } else {
                if (at == until) break
                val next = minOf(until, at + length - heldSize)
                hold(bytes, at, next)
                at = next
            }
        }
        return at
    }

    private fun hold(bytes: ByteArray, from: Int, until: Int) {
        val size = heldSize + until - from
        if (size > held.size) held = held.copyOf(maxOf(64, size, minOf(size * 2L, MAX_RECORD_BYTES * 2L).toInt()))
        bytes.copyInto(held, heldSize, from, until)
        heldSize = size
    }

    /**
     * How many bytes the record at [at], or the header, has. Where [available] bytes do not tell yet, how many would tell
     * more; [NONE] where there is no record.
     */
    private fun lengthOf(bytes: ByteArray, at: Int, available: Int): Int {
        val head = bytes[at].toInt()
        val size: Int
        val headSize: Int
        if (sawHeader) {
            if (head < 0) return NONE
            val idSize = (head and 3) + 1
            val sizeSize = (head shr 2 and 3) + 1
            headSize = 1 + idSize + sizeSize + (head shr 4 and 7) + 1
            if (available < headSize) return headSize
            size = unsignedAt(bytes, at + 1 + idSize, sizeSize)
        } else {
            headSize = HEADER
            if (available < headSize) return headSize
            size = intAt(bytes, at + HEADER - 4)
        }
        return if (size in 0..MAX_RECORD_BYTES) headSize + size else NONE
    }

    private fun deliver(bytes: ByteArray, from: Int, until: Int): Boolean {
        val fate = if (sawHeader) record(bytes, from, until) else header(bytes, from, until)
        when (fate) {
            RecordFate.READ -> doubtful = 0
            RecordFate.UNKNOWN -> if (doubtful++ == 0) doubtfulFrom = position
            RecordFate.NONSENSE -> return false
        }
        position += until - from
        return true
    }

    private fun header(bytes: ByteArray, from: Int, until: Int): RecordFate {
        sawHeader = true
        return if (sink.header(bytes, from, until)) RecordFate.READ else RecordFate.NONSENSE
    }

    private fun record(bytes: ByteArray, from: Int, until: Int): RecordFate {
        val head = bytes[from].toInt()
        val idSize = (head and 3) + 1
        val timeAt = from + 1 + idSize + (head shr 2 and 3) + 1
        val timeSize = (head shr 4 and 7) + 1
        val id = unsignedAt(bytes, from + 1, idSize)
        return sink.record(id, wideAt(bytes, timeAt, timeSize), bytes, from, timeAt + timeSize, until)
    }

    // Bytes after damage may look like records of entries that there are not.
    private fun stop() {
        readableEnd = if (doubtful > 0) doubtfulFrom else position
        recordsInNonsense = doubtful
        held = ByteArray(0)
        heldSize = 0
    }

    companion object {
        /** How each WPILOG begins. */
        const val MAGIC = "WPILOG"

        /** The header without its text. */
        const val HEADER = 12

        /** No logger writes a larger payload at once; what says it has is damage. */
        const val MAX_RECORD_BYTES = 1 shl 24
        private const val NONE = -1
    }
}
