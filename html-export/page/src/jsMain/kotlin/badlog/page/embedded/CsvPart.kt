package badlog.page.embedded

/** Removes the JSON line from the chunks of a bag, which leaves its CSV part. Blank lines before it are removed, too. */
internal class CsvPart(private val hasHeaderLine: Boolean) {
    private var isInHeader = hasHeaderLine
    private var sawHeader = false
    private var sawReturn = false

    /** Returns the part of [chunk], the next one of the file, that belongs to the CSV part. */
    fun filter(chunk: ByteArray): ByteArray {
        if (!isInHeader && !sawReturn) return chunk
        var at = 0
        while (at < chunk.size && isInHeader) {
            when (chunk[at++].toInt()) {
                LINE_FEED -> isInHeader = !sawHeader

                CARRIAGE_RETURN -> {
                    isInHeader = !sawHeader
                    sawReturn = sawHeader
                }

                else -> sawHeader = true
            }
        }
        if (sawReturn && at < chunk.size) {
            if (chunk[at].toInt() == LINE_FEED) at++
            sawReturn = false
        }
        return chunk.copyOfRange(at, chunk.size)
    }

    private companion object {
        const val LINE_FEED = 10
        const val CARRIAGE_RETURN = 13
    }
}
