package badlog.page.embedded

/**
 * Inflates gzip (RFC 1951 and 1952) where the browser's `DecompressionStream` fails. It reads streams of several members, and the readable
 * part of cut streams. It needs the whole compressed file in memory.
 *
 * @param sink receives the inflated bytes, in pieces.
 */
internal class Inflater(private val input: ByteArray, private val sink: (ByteArray) -> Unit) {
    private class DamageException : Exception()

    private val window = ByteArray(2 * PIECE)
    private var filled = 0
    private var given = 0
    private var at = 0
    private var bits = 0
    private var bitCount = 0
    private val fixedLengths = HuffmanCode(
        ByteArray(288) {
            if (it in 144..255) {
                9
            } else if (it in 256..279) {
                7
            } else {
                8
            }
        },
    )
    private val fixedDistances = HuffmanCode(ByteArray(30) { 5 })

    /** Whether the input ended too early or was damaged. */
    var isCut = false
        private set

    /** Inflates all bytes that can be read. */
    fun run() {
        try {
            while (at < input.size && skipHeader()) {
                inflateMember()
                at += TRAILER
            }
        } catch (_: DamageException) {
            // Everything before the cut, or before the invalid data, is good.
            isCut = true
        }
        give()
    }

    private fun skipHeader(): Boolean {
        if (byte() != 0x1f || byte() != 0x8b || byte() != 8) return false
        val flags = byte()
        at += 6
        if (flags and EXTRA != 0) at += byte() + (byte() shl 8)
        if (flags and NAME != 0) skipText()
        if (flags and COMMENT != 0) skipText()
        if (flags and CHECKSUM != 0) at += 2
        return true
    }

    private fun skipText() {
        while (byte() != 0) continue
    }

    private fun inflateMember() {
        bits = 0
        bitCount = 0
        do {
            val isLast = take(1) == 1
            when (take(2)) {
                0 -> copyStored()
                1 -> inflateBlock(fixedLengths, fixedDistances)
                2 -> inflateDynamic()
                else -> throw DamageException()
            }
        } while (!isLast)
        // Whole bytes that were read ahead belong to the trailer.
        at -= bitCount / 8
    }

    private fun copyStored() {
        at -= bitCount / 8
        bits = 0
        bitCount = 0
        val size = byte() + (byte() shl 8)
        at += 2
        repeat(size) { put(byte().toByte()) }
    }

    private fun inflateDynamic() {
        val lengthCount = take(5) + 257
        val distanceCount = take(5) + 1
        val orderCount = take(4) + 4
        val lengths = ByteArray(19)
        for (i in 0 until orderCount) lengths[CODE_ORDER[i]] = take(3).toByte()
        val code = HuffmanCode(lengths)
        val all = ByteArray(lengthCount + distanceCount)
        var filled = 0
        while (filled < all.size) {
            val symbol = symbol(code)
            var value: Byte = 0
            val count = when (symbol) {
                16 -> {
                    if (filled == 0) throw DamageException()
                    value = all[filled - 1]
                    3 + take(2)
                }

                17 -> 3 + take(3)

                18 -> 11 + take(7)

                else -> {
                    value = symbol.toByte()
                    1
                }
            }
            if (filled + count > all.size) throw DamageException()
            repeat(count) { all[filled++] = value }
        }
        inflateBlock(HuffmanCode(all.copyOf(lengthCount)), HuffmanCode(all.copyOfRange(lengthCount, all.size)))
    }

    private fun inflateBlock(literals: HuffmanCode, distances: HuffmanCode) {
        while (true) {
            val symbol = symbol(literals)
            if (symbol < 256) {
                put(symbol.toByte())
                continue
            }
            if (symbol == 256) return
            if (symbol > 285) throw DamageException()
            val length = LENGTHS[symbol - 257] + take(LENGTH_BITS[symbol - 257])
            val distanceSymbol = symbol(distances)
            if (distanceSymbol >= DISTANCES.size) throw DamageException()
            val distance = DISTANCES[distanceSymbol] + take(DISTANCE_BITS[distanceSymbol])
            if (distance > filled) throw DamageException()
            repeat(length) { put(window[filled - distance]) }
        }
    }

    private fun symbol(code: HuffmanCode): Int {
        var value = 0
        var first = 0
        var index = 0
        for (length in 1..HuffmanCode.MAX_LENGTH) {
            value = value or take(1)
            val count = code.counts[length]
            if (value - count < first) return code.symbols[index + value - first]
            index += count
            first = (first + count) shl 1
            value = value shl 1
        }
        throw DamageException()
    }

    private fun take(count: Int): Int {
        while (bitCount < count) {
            bits = bits or (byte() shl bitCount)
            bitCount += 8
        }
        val value = bits and ((1 shl count) - 1)
        bits = bits ushr count
        bitCount -= count
        return value
    }

    private fun byte(): Int {
        if (at >= input.size) throw DamageException()
        return input[at++].toInt() and 0xff
    }

    private fun put(byte: Byte) {
        if (filled == window.size) {
            give()
            window.copyInto(window, 0, PIECE, window.size)
            filled = PIECE
            given = PIECE
        }
        window[filled++] = byte
    }

    private fun give() {
        if (filled > given) sink(window.copyOfRange(given, filled))
        given = filled
    }

    private companion object {
        /** At least the 32 kB to which a match may refer back. */
        const val PIECE = 1 shl 16
        const val TRAILER = 8
        const val CHECKSUM = 2
        const val EXTRA = 4
        const val NAME = 8
        const val COMMENT = 16
        val CODE_ORDER = intArrayOf(16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15)
        val LENGTH_BITS = IntArray(29) { if (it < 8 || it == 28) 0 else it / 4 - 1 }
        val DISTANCE_BITS = IntArray(30) { if (it < 4) 0 else it / 2 - 1 }

        // Each code begins where the previous one ends; only the last length, the longest, does not follow this scheme.
        val LENGTHS = startsOf(LENGTH_BITS, 3).also { it[28] = 258 }
        val DISTANCES = startsOf(DISTANCE_BITS, 1)

        private fun startsOf(extraBits: IntArray, first: Int): IntArray {
            var start = first
            return IntArray(extraBits.size) { start.also { _ -> start += 1 shl extraBits[it] } }
        }
    }
}

/**
 * A canonical Huffman code (RFC 1951, 3.2.2).
 *
 * @param lengths the number of bits of each symbol; 0 for a symbol that does not occur.
 */
internal class HuffmanCode(lengths: ByteArray) {
    /** The number of symbols of each length, up to [MAX_LENGTH]. */
    val counts: IntArray = IntArray(MAX_LENGTH + 1)

    /** The symbols, ordered by length, then by number. */
    val symbols: IntArray = IntArray(lengths.size)

    init {
        for (length in lengths) counts[length.toInt()]++
        counts[0] = 0
        val next = IntArray(MAX_LENGTH + 2)
        for (length in 1..MAX_LENGTH) next[length + 1] = next[length] + counts[length]
        for (symbol in lengths.indices) {
            val length = lengths[symbol].toInt()
            if (length > 0) symbols[next[length]++] = symbol
        }
    }

    companion object {
        /** The maximum number of bits of a symbol. */
        const val MAX_LENGTH: Int = 15
    }
}
