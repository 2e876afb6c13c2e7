package badlog.exporter

import badlog.files.GzipReader
import java.io.InputStream
import java.util.concurrent.Future

/** Embeds a file that is already compressed with gzip. The page contains its exact bytes, which are inflated only for parsing. */
internal class GzipEmbedding(
    private val threads: ExportThreads,
    private val out: Base64Stream,
    private val parse: (bytes: ByteArray, from: Int, until: Int) -> Unit,
) {
    private class Piece {
        val bytes = ByteArray(SIZE)
        var parsing: Future<*>? = null
    }

    private val reader = GzipReader { bytes, size -> parse(bytes, 0, size) }
    private val inFlight = ArrayDeque<Piece>()
    private var done = 0L

    /** Embeds [source] to its end; [progress] receives the number of bytes done. */
    fun embed(source: InputStream, progress: (Long) -> Unit): EmbeddedFile = reader.use {
        do {
            val piece = if (inFlight.size < IN_FLIGHT) Piece() else awaitFirst()
            val size = source.readNBytes(piece.bytes, 0, SIZE)
            piece.parsing = threads.parse { reader.accept(piece.bytes, 0, size) }
            inFlight += piece
            out.write(piece.bytes, 0, size)
            done += size
            progress(done)
        } while (size == SIZE)
        while (inFlight.isNotEmpty()) awaitFirst()
        EmbeddedFile(done, reader.inflatedBytes, reader.isCut)
    }

    private fun awaitFirst(): Piece = inFlight.removeFirst().also { piece -> piece.parsing?.let(ExportThreads::await) }
}

private const val SIZE = 1 shl 18
private const val IN_FLIGHT = 4
