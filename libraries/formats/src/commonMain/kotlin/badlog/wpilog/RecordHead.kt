package badlog.wpilog

/** What bytes look like where a record is expected. */
internal enum class RecordLook {
    /** A record that belongs to the log: its entry was begun, its size fits the type, its time is near the others. */
    FITTING,

    /** Perhaps a record: its head is possible, and something in it is odd. */
    ODD,

    /** No record. */
    NONE,

    /** More bytes are needed to tell. */
    MORE,
}

/** What stands before the payload of a record. */
internal class RecordHead {
    /** The record's entry; 0 for a control record. */
    var id = 0
        private set

    /** When it was written. */
    var micros = 0.0
        private set

    /** How many bytes the payload has. */
    var size = 0
        private set

    /** What the record belongs to, as far as that was looked up; null for a control record and for an unknown entry. */
    var entry: Entry? = null

    /** Whether all records of its entry have one size, so that one that fits is surely no longer or shorter. */
    val hasOneSize: Boolean get() = entry?.hasOneSize == true

    /** How many bytes the whole record has. */
    var length = 0
        private set

    /** Reads the head at [at]; [RecordLook.FITTING] when it is possible. */
    fun read(bytes: ByteArray, at: Int, until: Int): RecordLook {
        if (at >= until) return RecordLook.MORE
        val bits = bytes[at].toInt()
        if (bits < 0) return RecordLook.NONE
        val idSize = (bits and 3) + 1
        val sizeSize = (bits shr 2 and 3) + 1
        val timeSize = (bits shr 4 and 7) + 1
        val headSize = 1 + idSize + sizeSize + timeSize
        if (headSize > until - at) return RecordLook.MORE
        size = unsignedAt(bytes, at + 1 + idSize, sizeSize)
        if (size !in 0..MAX_PAYLOAD_BYTES) return RecordLook.NONE
        id = unsignedAt(bytes, at + 1, idSize)
        micros = wideAt(bytes, at + 1 + idSize + sizeSize, timeSize)
        length = headSize + size
        return RecordLook.FITTING
    }

    companion object {
        /** No logger writes a larger payload at once; what says it has is damage. */
        const val MAX_PAYLOAD_BYTES = 1 shl 24
    }
}

/** The head of a control record's payload: its kind, and the entry that it is about. */
internal const val CONTROL_HEAD = 5

/** The kinds of control records. */
internal object ControlKind {
    const val START = 0
    const val FINISH = 1
    const val SET_METADATA = 2

    /** How many texts follow the head of a record of [kind]; -1 for a kind that does not exist. */
    fun textsOf(kind: Int): Int = when (kind) {
        START -> 3
        FINISH -> 0
        SET_METADATA -> 1
        else -> -1
    }
}

/** Whether the bytes from [from] until [until] are exactly one control record's payload, without a NUL in its texts. */
internal fun isControlPayload(bytes: ByteArray, from: Int, until: Int): Boolean {
    if (until - from < CONTROL_HEAD) return false
    val texts = ControlKind.textsOf(bytes[from].toInt())
    if (texts < 0 || intAt(bytes, from + 1) == 0) return false
    var at = from + CONTROL_HEAD
    repeat(texts) {
        if (until - at < Int.SIZE_BYTES) return false
        val size = intAt(bytes, at)
        at += Int.SIZE_BYTES
        if (size !in 0..until - at) return false
        for (i in at until at + size) if (bytes[i].toInt() == 0) return false
        at += size
    }
    return at == until
}
