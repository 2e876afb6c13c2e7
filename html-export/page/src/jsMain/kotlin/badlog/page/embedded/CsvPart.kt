package badlog.page.embedded

/** Removes the JSON line, and blank lines before it, from the chunks of a bag, which leaves its CSV part. */
internal class CsvPart(private val hasHeaderLine: Boolean) {
    private var isInHeader = hasHeaderLine
    private var sawHeader = false
    private var sawReturn = false

    /** Returns the CSV part of [chunk], the next chunk of the file. */
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
}

private const val LINE_FEED = 10
private const val CARRIAGE_RETURN = 13
