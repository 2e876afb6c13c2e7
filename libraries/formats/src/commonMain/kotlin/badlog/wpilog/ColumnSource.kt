package badlog.wpilog

import badlog.text.TextDecoder

/** Makes the columns of a file, as many as there may be. */
internal class ColumnSource(val keepsSamples: Boolean) {
    private val decoder = TextDecoder()
    private var made = 0

    /** Whether there may be [count] more. */
    fun hasRoomFor(count: Int): Boolean = made + count <= MOST

    /** A column for each of [paths]. */
    fun columns(paths: List<String>): List<SampleColumn> {
        made += paths.size
        return paths.map { SampleColumn(it, keepsSamples, decoder) }
    }

    private companion object {
        /** No program shows more topics, and damage could make millions. */
        const val MOST = 1 shl 16
    }
}
