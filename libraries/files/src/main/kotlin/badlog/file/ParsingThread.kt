package badlog.file

import badlog.recording.LogParser
import badlog.recording.Recording
import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors
import java.util.concurrent.Future

/**
 * Parses on a thread of its own, while the calling one inflates the next piece. Few pieces are in flight, which bounds the
 * memory.
 */
internal class ParsingThread(private val parser: LogParser) : AutoCloseable {
    private class Piece {
        val bytes = ByteArray(SIZE)
        var size = 0
        var parsing: Future<*>? = null
    }

    private val thread = Executors.newSingleThreadExecutor { work ->
        Thread(work, "badlog-parse").apply { isDaemon = true }
    }
    private val inFlight = ArrayDeque<Piece>()
    private var filling = Piece()

    /** Takes the first [size] of [bytes], which follow those of the calls before. Keeps no reference. */
    fun accept(bytes: ByteArray, size: Int) {
        var at = 0
        while (at < size) {
            val count = minOf(size - at, SIZE - filling.size)
            bytes.copyInto(filling.bytes, filling.size, at, at + count)
            filling.size += count
            at += count
            if (filling.size == SIZE) submit()
        }
    }

    /** Waits until all is parsed, and returns what was read. To be called once, last. */
    fun finish(): Recording {
        submit()
        while (inFlight.isNotEmpty()) awaitFirst()
        return parser.finish()
    }

    private fun submit() {
        val piece = filling
        piece.parsing = thread.submit { parser.accept(piece.bytes, 0, piece.size) }
        inFlight += piece
        filling = if (inFlight.size < IN_FLIGHT) Piece() else awaitFirst()
        filling.size = 0
    }

    private fun awaitFirst(): Piece {
        val piece = inFlight.removeFirst()
        try {
            piece.parsing?.get()
        } catch (e: ExecutionException) {
            throw e.cause ?: e
        }
        return piece
    }

    /** Drops what is not parsed yet. */
    override fun close() {
        thread.shutdownNow()
    }

    private companion object {
        const val SIZE = 1 shl 18
        const val IN_FLIGHT = 4
    }
}
