package badlog.formats.protobuf

/**
 * Reads the fields of one message of Protocol Buffers, from [at] until [until] of [bytes], in order; see
 * https://protobuf.dev/programming-guides/encoding. It never throws because of the bytes.
 */
internal class WireReader(private val bytes: ByteArray, private var at: Int, private val until: Int) {
    /** The number of the last field read. */
    var number = 0
        private set

    /** Its encoding: [VARINT], [FIXED_64], [SIZED] or [FIXED_32]. */
    var wire = VARINT
        private set

    /** Its bits, unless it is [SIZED]. */
    var bits = 0L
        private set

    /** Where the bytes of a [SIZED] field begin. */
    var from = 0
        private set

    /** Where the bytes of a [SIZED] field end. */
    val end: Int get() = at

    /** Whether the bytes are not a message. */
    var isBad = false
        private set

    /** Reads the next field. Returns false at the end, and if the bytes are not a message. */
    fun next(): Boolean {
        if (at >= until || isBad) return false
        val tag = varint()
        number = (tag ushr TAG_BITS).toInt()
        wire = (tag and TAG_MASK).toInt()
        if (number <= 0) isBad = true
        return !isBad && read()
    }

    /** Reads the next number of a packed list with the encoding [wire]. Returns false at the end. */
    fun nextPacked(wire: Int): Boolean {
        if (at >= until || isBad) return false
        this.wire = wire
        return read()
    }

    private fun read(): Boolean {
        when (wire) {
            VARINT -> bits = varint()

            FIXED_64 -> bits = fixed(Long.SIZE_BYTES)

            FIXED_32 -> bits = fixed(Int.SIZE_BYTES)

            SIZED -> {
                val size = varint()
                from = at
                if (size in 0L..until - at) at += size.toInt() else isBad = true
            }

            else -> isBad = true
        }
        return !isBad
    }

    private fun varint(): Long {
        var number = 0L
        for (shift in 0 until Long.SIZE_BITS step VARINT_BITS) {
            if (at >= until) break
            val byte = bytes[at++].toLong()
            number = number or ((byte and VARINT_MASK) shl shift)
            if (byte >= 0) return number
        }
        isBad = true
        return 0
    }

    private fun fixed(width: Int): Long {
        if (until - at < width) {
            isBad = true
            return 0
        }
        var number = 0L
        for (i in width - 1 downTo 0) number = (number shl Byte.SIZE_BITS) or (bytes[at + i].toLong() and 0xFF)
        at += width
        return number
    }

    companion object {
        const val VARINT = 0
        const val FIXED_64 = 1
        const val SIZED = 2
        const val FIXED_32 = 5
        private const val TAG_BITS = 3
        private const val TAG_MASK = 7L
        private const val VARINT_BITS = 7
        private const val VARINT_MASK = 0x7FL
    }
}
