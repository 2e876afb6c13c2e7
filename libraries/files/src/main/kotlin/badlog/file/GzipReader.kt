package badlog.file

import java.util.zip.DataFormatException
import java.util.zip.Inflater

/**
 * Inflates a gzip file that is pushed to it in pieces, and passes on all that can be inflated of it. A robot's file may
 * lack its trailer or be cut anywhere, may be several gzip members in a row, and may end in NULs or other remains.
 * Check sums are not looked at: a wrong one would not bring anything back.
 *
 * Nothing in the bytes makes it throw. Not safe for use by several threads.
 *
 * @param sink gets what was inflated: `[0, size)` of the array, which is used again after the call. What it throws,
 *   [accept] throws.
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

    // The last four bytes that the inflater was given.
    private var tail = 0

    /** How many bytes have been inflated so far. */
    public var inflatedBytes: Long = 0L
        private set

    /**
     * After the last piece: whether something is missing, because the stream broke off or cannot be inflated further.
     * A stream that its writer flushed but never closed, as the original badlog leaves it, lacks nothing.
     */
    public val isCut: Boolean
        get() = isDamaged || !sawBody || (stage == Stage.BODY && tail != FLUSH_MARK)

    /** Reads the bytes from [from] until [until] of [bytes], which follow those of the calls before. */
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

    /** Frees the memory outside the heap; after it, only the properties may be asked. */
    override fun close(): Unit = inflater.end()

    public companion object {
        private const val TRAILER = 8

        /** The end of the empty block by which a flush brings the stream to a whole byte. */
        private const val FLUSH_MARK = 0x0000FFFF

        /** How many bytes [isGzip] wants to see. */
        public const val SIGNATURE_SIZE: Int = 2

        /** Whether a file that begins with the first [size] of [bytes] is compressed with gzip, whatever its name. */
        public fun isGzip(bytes: ByteArray, size: Int = bytes.size): Boolean =
            size >= SIGNATURE_SIZE && bytes[0] == 0x1F.toByte() && bytes[1] == 0x8B.toByte()
    }
}
