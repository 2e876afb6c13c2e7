package badlog.files

import java.util.zip.DataFormatException
import java.util.zip.Inflater

/**
 * Inflates a gzip file that is pushed to it in pieces, and passes on everything that can be inflated. A robot's file
 * may lack its trailer or be cut anywhere, may consist of several gzip members, and may end in NULs or other remains.
 * Checksums are ignored: knowing that one is wrong would not recover anything.
 *
 * It never throws because of the bytes. Not thread-safe.
 *
 * @param sink receives the inflated bytes: `[0, size)` of the array, which is reused after the call. [accept] passes on
 *   its exceptions.
 */
public class GzipReader(private val sink: (bytes: ByteArray, size: Int) -> Unit) : AutoCloseable {
    private enum class Stage { HEADER, BODY, TRAILER, OVER }

    private val inflater = Inflater(true)
    private val inflated = ByteArray(1 shl 16)
    private var header = GzipHeader()
    private var trailerLeft = 0
    private var stage = Stage.HEADER
    private var isDamaged = false
    private var sawBody = false

    // The last four bytes passed to the inflater.
    private var tail = 0

    /** The number of bytes inflated so far. */
    public var inflatedBytes: Long = 0L
        private set

    /**
     * Whether data is missing, because the stream ends early or cannot be inflated further. Read it after the last piece. A stream that was
     * flushed but never closed, as by the original badlog, is complete.
     */
    public val isCut: Boolean
        get() = isDamaged || !sawBody || (stage == Stage.BODY && tail != FLUSH_MARK)

    /** Reads the next bytes, from [from] until [until] of [bytes]. */
    public fun accept(bytes: ByteArray, from: Int, until: Int) {
        var at = from
        while (at < until) {
            at = when (stage) {
                Stage.HEADER -> readHeader(bytes, at, until)
                Stage.BODY -> readBody(bytes, at, until)
                Stage.TRAILER -> readTrailer(at, until)
                Stage.OVER -> until
            }
        }
    }

    private fun readHeader(bytes: ByteArray, from: Int, until: Int): Int {
        var at = from
        while (at < until) {
            when (header.accept(bytes[at++].toInt() and 0xFF)) {
                GzipHeader.State.MORE -> continue
                GzipHeader.State.DONE -> beginBody()
                GzipHeader.State.NONE -> stage = Stage.OVER
            }
            break
        }
        return at
    }

    private fun beginBody() {
        stage = Stage.BODY
        sawBody = true
        tail = 0
    }

    private fun readBody(bytes: ByteArray, from: Int, until: Int): Int {
        inflater.setInput(bytes, from, until - from)
        do {
            val before = inflater.bytesWritten
            try {
                inflater.inflate(inflated)
            } catch (_: DataFormatException) {
                isDamaged = true
            }
            val size = (inflater.bytesWritten - before).toInt()
            if (size > 0) sink(inflated, size)
            inflatedBytes += size
        } while (size > 0 && !isDamaged)
        if (isDamaged || inflater.needsDictionary()) {
            isDamaged = true
            stage = Stage.OVER
            return until
        }
        val next = until - inflater.remaining
        for (i in maxOf(from, next - Int.SIZE_BYTES) until next) tail = tail shl 8 or (bytes[i].toInt() and 0xFF)
        if (inflater.finished()) {
            stage = Stage.TRAILER
            trailerLeft = TRAILER
        }
        return next
    }

    private fun readTrailer(from: Int, until: Int): Int {
        val size = minOf(trailerLeft, until - from)
        trailerLeft -= size
        if (trailerLeft == 0) {
            stage = Stage.HEADER
            header = GzipHeader()
            inflater.reset()
        }
        return from + size
    }

    /** Frees the memory outside the heap; afterwards, only the properties may be used. */
    override fun close(): Unit = inflater.end()

    public companion object {
        private const val TRAILER = 8

        /** The end of the empty block with which a flush aligns the stream to a byte. */
        private const val FLUSH_MARK = 0x0000FFFF

        /** The number of bytes that [isGzip] needs. */
        public const val SIGNATURE_SIZE: Int = 2

        /** Returns whether a file that begins with the first [size] of [bytes] is compressed with gzip, whatever its name. */
        public fun isGzip(bytes: ByteArray, size: Int = bytes.size): Boolean =
            size >= SIGNATURE_SIZE && bytes[0] == 0x1F.toByte() && bytes[1] == 0x8B.toByte()
    }
}
