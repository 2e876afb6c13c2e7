package badlog.bag

import badlog.recording.LogFormat
import badlog.recording.LogParser
import badlog.recording.Recording

/**
 * Reads a log of any of [formats], or else a bag or a CSV file. The content decides.
 *
 * @param formats what it may be besides a bag and a CSV file.
 * @param keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
 * @param bag makes the parser of a bag, or of a CSV file.
 */
public class RecordingParser(private val formats: List<LogFormat>, private val keepSamples: Boolean, private val bag: () -> BagParser) :
    LogParser {
    /**
     * A parser that reads a bag by itself.
     *
     * @param expectedBytes how long the file will be, if known; else 0.
     */
    public constructor(formats: List<LogFormat>, expectedBytes: Long = 0, keepSamples: Boolean = true) :
        this(formats, keepSamples, { BagParser(expectedBytes, keepSamples) })

    private val beginning = ByteArray(formats.maxOfOrNull { it.signatureSize } ?: 0)
    private var seen = 0
    private var parser: LogParser? = null

    override val rowCount: Int get() = parser?.rowCount ?: 0

    override var maxRows: Int = BagParser.MAX_ROWS

    override val isFull: Boolean get() = parser?.isFull == true

    override fun accept(bytes: ByteArray, from: Int, until: Int) {
        var at = from
        if (parser == null) {
            while (at < until && seen < beginning.size) beginning[seen++] = bytes[at++]
            if (seen < beginning.size) return
        }
        chosen().accept(bytes, at, until)
    }

    override fun finish(): Recording = chosen().finish()

    private fun chosen(): LogParser = parser ?: choose().also {
        parser = it
        it.accept(beginning, 0, seen)
    }

    private fun choose(): LogParser {
        val format = formats.find { it.matches(beginning, seen) }
        return (format?.parser(keepSamples) ?: bag()).also { it.maxRows = maxRows }
    }
}
