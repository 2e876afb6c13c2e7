package badlog.page.embedded

/**
 * A canonical Huffman code (RFC 1951, 3.2.2).
 *
 * @param lengths for each symbol how many bits it takes, 0 for one that does not occur.
 */
internal class HuffmanCode(lengths: ByteArray) {
    /** For each length, up to [MAX_LENGTH], how many symbols have it. */
    val counts: IntArray = IntArray(MAX_LENGTH + 1)

    /** The symbols, by length, then by number. */
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
        /** The most bits a symbol can take. */
        const val MAX_LENGTH: Int = 15
    }
}
