package badlog.page.reading

import badlog.core.bag.RecordingParser
import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.formats.LOG_FORMATS
import badlog.page.embedded.GZIP
import badlog.page.embedded.Inflater
import badlog.page.embedded.PIECE
import badlog.page.embedded.bytesOf
import org.w3c.files.File
import kotlin.js.Promise

/**
 * Reads a log from the files that a person opened, one after the other; a Driver Station log has two. Used in the worker, or on the page if
 * there is none. Only gzipped files are in memory as a whole.
 *
 * @param wanted the only topics to keep; null for all.
 * @param onProgress receives the fraction of the bytes that has been read.
 */
internal class LogFileReader(
    private val files: List<File>,
    private val wanted: WantedTopics? = null,
    private val onProgress: (Double) -> Unit,
) {
    private val size = files.sumOf { it.size.toDouble() }
    private val parser = wanted?.parser(size.toLong()) ?: RecordingParser(LOG_FORMATS, size.toLong())
    private var done = 0.0
    private var cut: Problem? = null

    /** Reads all files, and promises the recording; rejected if a file cannot be read, for example because it was removed. */
    fun read(): Promise<Recording> {
        val all = files.fold(Promise.resolve(Unit)) { before, file -> before.then { begin(file) }.unsafeCast<Promise<Unit>>() }
        return all.then {
            val read = parser.finish().let { wanted?.of(it) ?: it }
            cut?.let { read + it } ?: read
        }
    }

    private fun begin(file: File): Promise<Unit> = bytesOf(file, 0.0, GZIP.size.toDouble()).then { head ->
        if (head.contentEquals(GZIP)) inflate(file) else continueFrom(file, 0.0)
    }.unsafeCast<Promise<Unit>>()

    private fun inflate(file: File) = bytesOf(file, 0.0, file.size.toDouble()).then { bytes ->
        var inflated = 0.0
        val inflater = Inflater(bytes) {
            inflated += it.size
            parser.accept(it, 0, it.size)
        }
        inflater.run()
        if (inflater.isCut) cut = gzipCut(inflated)
        advance(bytes.size)
    }

    private fun continueFrom(file: File, from: Double): Promise<Unit> = bytesOf(file, from, from + PIECE).then { bytes ->
        parser.accept(bytes, 0, bytes.size)
        advance(bytes.size)
        if (bytes.size < PIECE) Unit else continueFrom(file, from + PIECE)
    }.unsafeCast<Promise<Unit>>()

    private fun advance(bytes: Int) {
        done += bytes
        onProgress(done / size)
    }
}

/** Returns the problem of a compressed file that is readable only up to [inflatedBytes]. */
internal fun gzipCut(inflatedBytes: Double) =
    Problem(ProblemKind.GZIP_CUT, "The compressed file is cut off or damaged; the $inflatedBytes bytes before that were read.")
