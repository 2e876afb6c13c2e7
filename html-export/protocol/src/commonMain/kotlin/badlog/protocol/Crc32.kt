package badlog.protocol

/**
 * The CRC-32 of gzip and PNG (reflected, 0xEDB88320), calculated from bytes that arrive in pieces. The exporter writes it beside each line
 * of an embedded file, and the page checks it. Pages may contain hundreds of megabytes, so it processes eight bytes at a time, with eight
 * tables.
 */
class Crc32 {
    private var state = -1

    /** The checksum of all bytes so far. */
    val value: Int get() = state.inv()

    /** Adds [bytes] from index [from] until [until]. */
    fun update(bytes: ByteArray, from: Int = 0, until: Int = bytes.size) {
        val table = TABLE
        var crc = state
        var at = from
        while (at + 8 <= until) {
            crc = crc xor wordAt(bytes, at)
            val next = wordAt(bytes, at + 4)
            crc = table[0x700 or (crc and 0xFF)] xor table[0x600 or (crc ushr 8 and 0xFF)] xor
                table[0x500 or (crc ushr 16 and 0xFF)] xor table[0x400 or (crc ushr 24)] xor
                table[0x300 or (next and 0xFF)] xor table[0x200 or (next ushr 8 and 0xFF)] xor
                table[0x100 or (next ushr 16 and 0xFF)] xor table[next ushr 24]
            at += 8
        }
        while (at < until) crc = table[(crc xor bytes[at++].toInt()) and 0xFF] xor (crc ushr 8)
        state = crc
    }

    fun reset() {
        state = -1
    }

    private companion object {
        const val POLYNOMIAL = 0xEDB88320.toInt()

        /** The contribution of each byte value when 0 to 7 other bytes follow: eight tables of 256. */
        val TABLE = IntArray(8 * 256).also { table ->
            for (byte in 0 until 256) {
                var crc = byte
                repeat(8) { crc = if (crc and 1 == 0) crc ushr 1 else (crc ushr 1) xor POLYNOMIAL }
                table[byte] = crc
            }
            for (at in 256 until table.size) table[at] = table[table[at - 256] and 0xFF] xor (table[at - 256] ushr 8)
        }

        fun wordAt(bytes: ByteArray, at: Int): Int = (bytes[at].toInt() and 0xFF) or (bytes[at + 1].toInt() and 0xFF shl 8) or
            (bytes[at + 2].toInt() and 0xFF shl 16) or (bytes[at + 3].toInt() shl 24)
    }
}
