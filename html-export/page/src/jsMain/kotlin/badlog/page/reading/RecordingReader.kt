package badlog.page.reading

import badlog.core.bag.RecordingParser
import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.formats.LOG_FORMATS
import badlog.page.embedded.Base64
import badlog.page.embedded.Inflation
import badlog.page.embedded.LineSums
import badlog.viewer.text.bytesText
import kotlin.js.Promise

/**
 * Reads a recording from the pieces of base64 in a page. Used in the worker, or on the page if there is none.
 *
 * @param lineSums the CRC-32 of each line, as calculated by the exporter.
 * @param onProgress receives the fraction of the bytes that has been read, at most [STEPS] times.
 */
internal class RecordingReader(
    private val expectedBytes: Double,
    private val isWhole: Boolean,
    private val lineSums: Array<Int>,
    private val onProgress: (Double) -> Unit,
) {
    private val parser = RecordingParser(LOG_FORMATS, expectedBytes.toLong())
    private var reported = 0.0
    private val inflation = Inflation(expectedBytes, isWhole, ::read)
    private val sums = LineSums()
    private var hasEnded = false
    private lateinit var checkSums: () -> Unit
    private val summed = Promise<Unit> { resolve, _ -> checkSums = { resolve(Unit) } }

    /** The recording, once everything has been read and checked. */
    val recording: Promise<ReadLog> = Promise.all(arrayOf(inflation.finished, summed)).then {
        val isIntact = sums.fit(lineSums) && (!isWhole || inflation.inflatedBytes == expectedBytes)
        ReadLog(build(), !isIntact)
    }

    /** Accepts the next piece. The promise is fulfilled when there is room for another. */
    fun accept(base64: String): Promise<Unit> {
        val bytes = Base64.decode(base64)
        sums.add(bytes, isLast = base64.endsWith('\n'))
        return inflation.accept(bytes)
    }

    /** Marks the end of the pieces. It may be called again. */
    fun end() {
        if (!hasEnded) sums.add(ByteArray(0), isLast = true)
        hasEnded = true
        inflation.end()
        checkSums()
    }

    private fun read(bytes: ByteArray) {
        val excess = inflation.inflatedBytes - expectedBytes
        parser.accept(bytes, 0, if (excess > 0) bytes.size - excess.toInt() else bytes.size)
        if (inflation.inflatedBytes - reported > expectedBytes / STEPS) {
            reported = inflation.inflatedBytes
            onProgress(reported / expectedBytes)
        }
    }

    private fun build(): Recording {
        val recording = parser.finish()
        val missing = expectedBytes - inflation.inflatedBytes
        if (missing <= 0) return recording
        return recording + Problem(
            ProblemKind.GZIP_CUT,
            "The last ${bytesText(missing)} of ${bytesText(expectedBytes)} cannot be read; the page may have been cut in copying.",
        )
    }
}

private const val STEPS = 100
