package badlog.exporter

import java.io.InputStream
import java.util.concurrent.Future
import java.util.zip.Deflater

/**
 * One piece of a file that is compressed into a gzip stream. It is deflated independently of its neighbors, so that several can be deflated
 * in parallel. It uses the bytes before it as a dictionary and ends on a byte boundary, so that the pieces in sequence are one deflate
 * stream, except for its [END]. A piece without a dictionary begins a part of the stream that can be inflated by itself.
 *
 * Pieces are reused, because their buffers are the memory that an export needs.
 */
internal class DeflatePiece {
    private val deflater = Deflater(LEVEL, true)
    private var dictionarySize = 0

    /** Whether the piece can be inflated without the pieces before it. */
    var beginsPart = true
        private set

    /** The dictionary, followed by the piece's own bytes, from index [from] until [until]. */
    val bytes = ByteArray(DICTIONARY + SIZE)
    val from: Int get() = dictionarySize
    var until = 0
        private set
    val isLast: Boolean get() = until - from < SIZE

    /** The result of [deflate], from index 0 until [deflatedSize]. */
    var deflated = ByteArray(SIZE / 2)
        private set
    var deflatedSize = 0
        private set

    /** The tasks for this piece that run in other threads. */
    var work: List<Future<*>> = emptyList()

    /** Reads the next bytes of [source]. They follow the piece [before]; if it is null, they begin a new part. */
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

        /** An empty last block, which ends the stream. */
        val END = byteArrayOf(3, 0)

        /** The maximum distance to which deflate looks back. */
        private const val DICTIONARY = 1 shl 15

        private const val LEVEL = 4
    }
}
