package badlog.web

/**
 * A part of a file.
 *
 * @property from the offset of its first byte.
 * @property length the number of bytes; 0 if the requested part is not in the file.
 */
internal class ByteRange(val from: Long, val length: Long) {
    companion object {
        private val RANGE = Regex("""bytes=(\d*)-(\d*)""")

        /**
         * Returns the part of a file of [size] bytes that [header] requests. Returns null if it requests the whole file, or something that
         * a server may ignore, such as several parts.
         */
        fun of(header: String?, size: Long): ByteRange? {
            val (from, to) = RANGE.matchEntire(header ?: return null)?.destructured ?: return null
            if (from.isEmpty() && to.isEmpty()) return null
            // The last bytes.
            if (from.isEmpty()) return size.coerceAtMost(number(to)).let { ByteRange(size - it, it) }
            val first = number(from)
            val last = if (to.isEmpty()) size - 1 else number(to).coerceAtMost(size - 1)
            if (to.isNotEmpty() && number(to) < first) return null
            return ByteRange(first, (last - first + 1).coerceAtLeast(0))
        }

        // A number with too many digits is larger than any file.
        private fun number(digits: String) = digits.toLongOrNull() ?: Long.MAX_VALUE
    }
}
