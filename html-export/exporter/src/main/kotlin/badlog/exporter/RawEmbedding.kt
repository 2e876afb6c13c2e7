package badlog.exporter

import java.io.InputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.zip.CRC32

/**
 * Embeds an uncompressed file: deflates it piece by piece on all cores, into one gzip member. Each part that can be inflated by itself is
 * one line of the text, between a line with the member's header and a line with its end. The calling thread reads and writes. The number of
 * pieces in progress is limited, which bounds the memory for files of any size.
 */
internal class RawEmbedding(
    private val threads: ExportThreads,
    private val out: Base64Stream,
    private val parse: (bytes: ByteArray, from: Int, until: Int) -> Unit = { _, _, _ -> },
) {
    private val pieces = ArrayList<DeflatePiece>()
    private val inFlight = ArrayDeque<DeflatePiece>()
    private val check = CRC32()
    private var read = 0L
    private var done = 0L

    /** Embeds [source] to its end; [progress] receives the number of bytes done. */
    fun embed(source: InputStream, progress: (Long) -> Unit = {}): EmbeddedFile {
        out.write(HEADER)
        try {
            var last: DeflatePiece? = null
            var count = 0
            do {
                val piece = if (pieces.size < ExportThreads.CORES + SPARE) newPiece() else next(progress)
                piece.fill(source, last.takeUnless { count % PIECES_OF_PART == 1 })
                count++
                submit(piece)
                last = piece
            } while (!piece.isLast)
            while (inFlight.isNotEmpty()) next(progress)
        } finally {
            pieces.forEach { it.close() }
        }
        out.endLine()
        out.write(DeflatePiece.END)
        out.write(trailer())
        return EmbeddedFile(read, read, isCut = false)
    }

    private fun newPiece() = DeflatePiece().also { pieces += it }

    private fun submit(piece: DeflatePiece) {
        check.update(piece.bytes, piece.from, piece.until - piece.from)
        read += piece.until - piece.from
        piece.work = listOf(
            threads.deflate(piece::deflate),
            threads.parse { parse(piece.bytes, piece.from, piece.until) },
        )
        inFlight += piece
    }

    private fun next(progress: (Long) -> Unit): DeflatePiece {
        val piece = inFlight.removeFirst()
        piece.work.forEach(ExportThreads::await)
        if (piece.beginsPart) out.endLine()
        out.write(piece.deflated, 0, piece.deflatedSize)
        done += piece.until - piece.from
        progress(done)
        return piece
    }

    private fun trailer() = ByteBuffer.allocate(TRAILER_SIZE).order(ByteOrder.LITTLE_ENDIAN)
        .putInt(check.value.toInt())
        .putInt(read.toInt())
        .array()

    private companion object {
        const val TRAILER_SIZE = 8

        /** The number of pieces in a part. The first piece is a separate part, because all others wait for the header in it. */
        const val PIECES_OF_PART = 4

        /** The header of the gzip member: deflate, no name, no time, unknown system. */
        val HEADER = byteArrayOf(0x1F, 0x8B.toByte(), 8, 0, 0, 0, 0, 0, 0, -1)

        /** The number of pieces besides those being deflated: read ahead, or waiting to be written. */
        const val SPARE = 4
    }
}
