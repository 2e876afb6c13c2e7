package badlog.formats.wpilog

/** Returns the 32 bits at [at]. */
internal fun intAt(bytes: ByteArray, at: Int): Int = (bytes[at].toInt() and 0xFF) or (bytes[at + 1].toInt() and 0xFF shl 8) or
    (bytes[at + 2].toInt() and 0xFF shl 16) or (bytes[at + 3].toInt() shl 24)

/** Returns the 64 bits at [at]. */
internal fun longAt(bytes: ByteArray, at: Int): Long = (intAt(bytes, at).toLong() and 0xFFFFFFFFL) or (intAt(bytes, at + 4).toLong() shl 32)

/** Returns the [width] bytes (1 to 4) at [at] as an unsigned number. For 4 bytes, the highest bit becomes the sign. */
internal fun unsignedAt(bytes: ByteArray, at: Int, width: Int): Int {
    val first = bytes[at].toInt() and 0xFF
    if (width == 1) return first
    val two = first or (bytes[at + 1].toInt() and 0xFF shl 8)
    if (width == 2) return two
    val three = two or (bytes[at + 2].toInt() and 0xFF shl 16)
    return if (width == 3) three else three or (bytes[at + 3].toInt() shl 24)
}

/**
 * Returns the [width] bytes (1 to 8) at [at] as a number, signed for 8 bytes. It is exact up to 2^53, and rounded beyond. Does not use a
 * 64-bit integer, which in JavaScript is an object.
 */
internal fun wideAt(bytes: ByteArray, at: Int, width: Int): Double {
    if (width < 4) return unsignedAt(bytes, at, width).toDouble()
    val low = unsignedOf(intAt(bytes, at))
    return if (width == 4) low else low + unsignedAt(bytes, at + 4, width - 4) * TWO_32
}

private fun unsignedOf(bits: Int): Double = if (bits >= 0) bits.toDouble() else bits + TWO_32

private const val TWO_32 = 4294967296.0
