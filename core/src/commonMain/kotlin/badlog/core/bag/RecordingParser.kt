package badlog.core.bag

import badlog.core.recording.LogFormat
import badlog.core.recording.LogParser
import badlog.core.recording.Recording

/**
 * Reads a log in one of [formats], or otherwise a bag or a CSV file. The content decides.
 *
 * @param formats the formats to recognize besides bag and CSV.
 * @param keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
 * @param bag creates the parser of a bag or a CSV file.
 */
public class RecordingParser(private val formats: List<LogFormat>, private val keepSamples: Boolean, private val bag: () -> BagParser) :
    LogParser {
    /**
     * Creates a parser that uses a [BagParser] of its own for a bag.
     *
     * @param expectedBytes the length of the file, if known; otherwise 0.
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
