package badlog.html

import java.io.InputStream
import java.util.concurrent.Future
import java.util.zip.Deflater

/**
 * One piece of a file on its way into a gzip stream. It is deflated without its neighbors, so several are at a time,
 * but knows the bytes before it as a dictionary and ends on a byte, so the pieces one after another are one deflate
 * stream but for its [END]. A piece that knows none begins a part of the stream that can be inflated by itself.
 *
 * Made once and filled again and again: its buffers are what an export costs in memory.
 */
internal class DeflatePiece {
    private val deflater = Deflater(LEVEL, true)
    private var dictionarySize = 0

    /** Whether it can be inflated without the pieces before it. */
    var beginsPart = true
        private set

    /** The dictionary, then the piece's own bytes, which stand in [[from], [until]). */
    val bytes = ByteArray(DICTIONARY + SIZE)
    val from: Int get() = dictionarySize
    var until = 0
        private set
    val isLast: Boolean get() = until - from < SIZE

    /** What [deflate] made, in [[0], [deflatedSize]). */
    var deflated = ByteArray(SIZE / 2)
        private set
    var deflatedSize = 0
        private set

    /** The work on this piece that other threads do. */
    var work: List<Future<*>> = emptyList()

    /** Takes the next bytes of [source], which follow those of [before]; null begins a new part. */
    fun fill(source: InputStream, before: DeflatePiece?) {
        beginsPart = before == null
        dictionarySize = 0
        if (before != null) {
            dictionarySize = minOf(DICTIONARY, before.until)
            before.bytes.copyInto(bytes, 0, before.until - dictionarySize, before.until)
        }
        until = from + source.readNBytes(bytes, from, SIZE)
    }

    /** Deflates the piece into [deflated]. */
    fun deflate() {
        deflater.reset()
        if (dictionarySize > 0) deflater.setDictionary(bytes, 0, dictionarySize)
        deflater.setInput(bytes, from, until - from)
        deflatedSize = 0
        do {
            if (deflatedSize == deflated.size) deflated = deflated.copyOf(deflated.size * 2)
            deflatedSize += deflater.deflate(deflated, deflatedSize, deflated.size - deflatedSize, Deflater.SYNC_FLUSH)
        } while (deflatedSize == deflated.size)
    }

    /** Frees the memory outside the heap. */
    fun close() = deflater.end()

    companion object {
        const val SIZE = 1 shl 19

        /** An empty block that is the last one, and so ends the stream. */
        val END = byteArrayOf(3, 0)

        /** As far back as deflate ever looks. */
        private const val DICTIONARY = 1 shl 15

        private const val LEVEL = 4
    }
}
