package badlog.fetch

import java.nio.ByteBuffer

/** Reads MessagePack in [bytes] as NetworkTables sends it for topics of whole numbers, or of a 64-bit struct. */
internal class MessagePackReader(private val bytes: ByteBuffer) {
    /** Whether there are bytes left. */
    val hasNext: Boolean get() = bytes.hasRemaining()

    /** Returns the size of the next value if it is an array; otherwise null. */
    fun arraySize(): Int? {
        val first = unsigned()
        return if (first in FIX_ARRAY..FIX_ARRAY_END) first - FIX_ARRAY else null
    }

    /** Returns the next value if it is a whole number; otherwise null. */
    fun number(): Long? = when (val first = unsigned()) {
        in 0..POSITIVE_END -> first.toLong()
        UINT_8 -> unsigned().toLong()
        UINT_16 -> bytes.getShort().toLong() and 0xFFFF
        UINT_32 -> bytes.getInt().toLong() and 0xFFFF_FFFF
        UINT_64, INT_64 -> bytes.getLong()
        INT_8 -> bytes.get().toLong()
        INT_16 -> bytes.getShort().toLong()
        INT_32 -> bytes.getInt().toLong()
        in NEGATIVE..BYTE_END -> first.toByte().toLong()
        else -> null
    }

    /** Returns the next value if it is a whole number, or one in 8 bytes, lowest byte first; otherwise null. */
    fun word(): Long? {
        if (bytes.get(bytes.position()).toInt() and BYTE_END != BINARY_8) return number()
        bytes.get()
        if (unsigned() != Long.SIZE_BYTES) return null
        return java.lang.Long.reverseBytes(bytes.getLong())
    }

    private fun unsigned() = bytes.get().toInt() and BYTE_END
}

private const val POSITIVE_END = 0x7F
private const val FIX_ARRAY = 0x90
private const val FIX_ARRAY_END = 0x9F
private const val BINARY_8 = 0xC4
private const val UINT_8 = 0xCC
private const val UINT_16 = 0xCD
private const val UINT_32 = 0xCE
private const val UINT_64 = 0xCF
private const val INT_8 = 0xD0
private const val INT_16 = 0xD1
private const val INT_32 = 0xD2
private const val INT_64 = 0xD3
private const val NEGATIVE = 0xE0
private const val BYTE_END = 0xFF
