package badlog.formats.driverstation

/** Returns the byte at [at], from 0 to 255. */
internal fun byteAt(bytes: ByteArray, at: Int): Int = bytes[at].toInt() and 0xFF

/** Returns the two bytes at [at] as a number, the high byte first. */
internal fun shortAt(bytes: ByteArray, at: Int): Int = byteAt(bytes, at) shl 8 or byteAt(bytes, at + 1)

/** Returns the 32 bits at [at], the highest first. */
internal fun wordAt(bytes: ByteArray, at: Int): Int = shortAt(bytes, at) shl 16 or shortAt(bytes, at + 2)

/** Returns the whole seconds since 1904 of the time at [at]; the highest 32 of its 64 bits are 0. */
internal fun secondsAt(bytes: ByteArray, at: Int): Double = unsigned(wordAt(bytes, at + 4))

/** Returns the fraction of a second of the time at [at], which follows its whole seconds. */
internal fun fractionAt(bytes: ByteArray, at: Int): Double =
    (unsigned(wordAt(bytes, at + 8)) + unsigned(wordAt(bytes, at + 12)) / TWO_32) / TWO_32

private fun unsigned(bits: Int): Double = if (bits >= 0) bits.toDouble() else bits + TWO_32

private const val TWO_32 = 4294967296.0
