package badlog.files

import badlog.core.bag.BagParser
import badlog.core.bag.RecordingParser
import badlog.core.bag.RowBatch
import badlog.core.bag.RowBatchParser
import badlog.core.recording.LogFormat
import badlog.core.recording.Recording
import java.util.concurrent.Callable
import java.util.concurrent.ExecutionException
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.Future
import java.util.concurrent.atomic.AtomicInteger

/**
 * Parses on separate threads, while the calling one reads or inflates the next piece. The rows of a bag are read in batches on
 * several cores and joined on one thread, which also reads everything but plain rows. Few pieces are in progress, which bounds the
 * memory.
 *
 * @param options how the log is read, on at least 2 cores.
 */
internal class ParsingThreads(
    formats: List<LogFormat>,
    private val expectedBytes: Long,
    private val options: ReadOptions,
    private val expectedLines: Long = 0,
    private val pieceSize: Int = PIECE_SIZE,
) : AutoCloseable {
    private class Piece(size: Int) {
        val bytes = ByteArray(size)
        var size = 0
        var rows: RowBatchParser? = null
        var parsing: Future<*>? = null
    }

    private var bag: BagParser? = null
    private val parser = RecordingParser(formats, options.keepSamples) { bagParser().also { bag = it } }.limited()
    private val batching = pool("badlog-rows", options.cores)
    private val putting = pool("badlog-parse", 1)
    private val inFlight = ArrayDeque<Piece>()
    private var filling = Piece(pieceSize)

    // Until the header is read, each piece waits for the previous one.
    private var mayBeBag = true

    /** Whether nothing more will be read. */
    @Volatile
    var isFull = false
        private set
    private var readsDecimalComma: BooleanArray? = null

    /** Accepts the next bytes, the first [size] of [bytes]. Keeps no reference to the array. */
    fun accept(bytes: ByteArray, size: Int) {
        var at = 0
        while (at < size) {
            val count = minOf(size - at, pieceSize - filling.size)
            bytes.copyInto(filling.bytes, filling.size, at, at + count)
            filling.size += count
            at += count
            if (filling.size == pieceSize) submit(filling.lastLineEnd())
        }
    }

    /** Waits until everything is parsed, and returns the recording. Call it once, last. */
    fun finish(): Recording {
        submit(filling.size)
        while (inFlight.isNotEmpty()) awaitFirst()
        return parser.finish()
    }

    /** Drops the pieces that are not parsed yet. */
    override fun close() {
        putting.shutdownNow()
        batching.shutdownNow()
    }

    /** Submits the first [end] bytes of the piece; the others begin the next one. */
    private fun submit(end: Int) {
        val piece = filling
        filling = if (inFlight.size < options.cores + SPARE_PIECES) Piece(pieceSize) else awaitFirst()
        piece.bytes.copyInto(filling.bytes, 0, end, piece.size)
        filling.size = piece.size - end
        piece.size = end
        val batch = readsDecimalComma?.let { columns -> batching.submit(Callable { batchOf(piece, columns) }) }
        piece.parsing = putting.submit { put(piece, batch) }
        inFlight += piece
        if (mayBeBag && readsDecimalComma == null) {
            await(piece.parsing)
            mayBeBag = bag != null
            readsDecimalComma = bag?.readsDecimalComma
        }
    }

    private fun batchOf(piece: Piece, columns: BooleanArray): RowBatch? {
        val rows = piece.rows ?: RowBatchParser(columns, options.keepSamples).also { piece.rows = it }
        return rows.parse(piece.bytes, 0, piece.size)
    }

    private fun put(piece: Piece, batching: Future<RowBatch?>?) {
        val batch = await(batching)
        if (batch == null || bag?.accept(batch) != true) parser.accept(piece.bytes, 0, piece.size)
        isFull = parser.isFull
    }

    private fun bagParser() = BagParser(expectedBytes, options.keepSamples, options.sinks, expectedLines, ::forAll)

    private fun awaitFirst(): Piece = inFlight.removeFirst().also { await(it.parsing) }

    private fun forAll(count: Int, work: (Int) -> Unit) {
        val next = AtomicInteger()
        fun share() = generateSequence { next.getAndIncrement().takeIf { it < count } }.forEach(work)
        val others = List(options.cores - 1) { batching.submit { share() } }
        share()
        for (other in others) await(other)
    }

    private companion object {
        const val PIECE_SIZE = 1 shl 18
        const val LINE_FEED = '\n'.code.toByte()

        /** The number of pieces in progress besides those that are being read. */
        const val SPARE_PIECES = 3

        fun pool(name: String, size: Int): ExecutorService =
            Executors.newFixedThreadPool(size) { work -> Thread(work, name).apply { isDaemon = true } }

        fun <T> await(work: Future<T>?): T? = try {
            work?.get()
        } catch (e: ExecutionException) {
            throw e.cause ?: e
        }

        /** Returns the end of the last complete line; the end of the piece if it has none. */
        fun Piece.lastLineEnd(): Int {
            var end = size
            while (end > 0 && bytes[end - 1] != LINE_FEED) end--
            return if (end == 0) size else end
        }
    }
}
