package badlog.formats.wpilog

/** The verdict on the bytes where a record is expected. */
internal enum class RecordLook {
    /** A record that belongs to the log. Its entry was started, its size fits the type, and its time is near the others. */
    FITTING,

    /** Possibly a record: its head is valid, but something in it is odd. */
    ODD,

    /** Not a record. */
    NONE,

    /** More bytes are needed to decide. */
    MORE,
}

/** The part of a record before its payload. */
internal class RecordHead {
    /** The record's entry; 0 for a control record. */
    var id = 0
        private set

    /** Its time, in µs. */
    var micros = 0.0
        private set

    /** The size of the payload in bytes. */
    var size = 0
        private set

    /** The record's entry, if it was looked up; null for a control record and for an unknown entry. */
    var entry: Entry? = null

    /** Whether all records of its entry have the same size, so that the size of a fitting one is certain. */
    val hasOneSize: Boolean get() = entry?.hasOneSize == true

    /** The size of the whole record in bytes. */
    var length = 0
        private set

    /** Reads the head at [at]. Returns [RecordLook.FITTING] if it is valid. */
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
        /** The maximum size of a payload: no logger writes a larger one, so a larger size is damage. */
        const val MAX_PAYLOAD_BYTES = 1 shl 24
    }
}

/** The size of the head of a control record's payload: its kind, and the entry that it is about. */
internal const val CONTROL_HEAD = 5

/** The kinds of control records. */
internal object ControlKind {
    const val START = 0
    const val FINISH = 1
    const val SET_METADATA = 2

    /** Returns the number of texts after the head of a record of [kind]. -1 for a kind that does not exist. */
    fun textsOf(kind: Int): Int = when (kind) {
        START -> 3
        FINISH -> 0
        SET_METADATA -> 1
        else -> -1
    }
}

/** Returns whether the bytes from [from] until [until] are exactly one control record's payload, without a NUL in its texts. */
internal fun isControlPayload(bytes: ByteArray, from: Int, until: Int): Boolean = controlEnd(bytes, from, until) == until

/**
 * Returns whether the bytes from [from] until [until] may be read as one control record's payload. Some loggers write more after the texts
 * of a start record, which WPILib's reader ignores.
 */
internal fun mayBeControlPayload(bytes: ByteArray, from: Int, until: Int): Boolean {
    val end = controlEnd(bytes, from, until)
    return end == until || (end > 0 && bytes[from].toInt() == ControlKind.START && until - end <= MAX_EXTRA)
}

/** Returns where the texts of a control record's payload end; -1 if it is not one. */
private fun controlEnd(bytes: ByteArray, from: Int, until: Int): Int {
    if (until - from < CONTROL_HEAD) return -1
    val texts = ControlKind.textsOf(bytes[from].toInt())
    if (texts < 0 || intAt(bytes, from + 1) == 0) return -1
    var at = from + CONTROL_HEAD
    repeat(texts) {
        if (until - at < Int.SIZE_BYTES) return -1
        val size = intAt(bytes, at)
        at += Int.SIZE_BYTES
        if (size !in 0..until - at) return -1
        for (i in at until at + size) if (bytes[i].toInt() == 0) return -1
        at += size
    }
    return at
}

/** More bytes than this after the texts are damage. */
private const val MAX_EXTRA = 64
