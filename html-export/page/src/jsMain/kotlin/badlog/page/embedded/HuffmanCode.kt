package badlog.page.embedded

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
