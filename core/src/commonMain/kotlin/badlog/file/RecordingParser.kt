package badlog.file

import badlog.bag.BagParser
import badlog.bag.FileSignature
import badlog.recording.Recording
import badlog.wpilog.WpilogParser

/**
 * Reads a log of any format that is pushed to it in pieces of any size: a bag, a CSV file or a WPILOG. The content decides.
 * As [BagParser] and [WpilogParser] do, it never throws for what is in the bytes, and wants compressed files inflated.
 *
 * @param expectedBytes how long the file will be, if known; else 0.
 * @param keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
 */
public class RecordingParser(private val expectedBytes: Long = 0, private val keepSamples: Boolean = true) {
    private val beginning = ByteArray(FileSignature.BYTES)
    private var seen = 0
    private var bag: BagParser? = null
    private var wpilog: WpilogParser? = null

    /** How many rows have been read so far, or records of a WPILOG. */
    public val rowCount: Int get() = bag?.rowCount ?: wpilog?.recordCount ?: 0

    /** Reads the bytes from [from] until [until] of [bytes], which follow those of the calls before. Keeps no reference. */
    public fun accept(bytes: ByteArray, from: Int = 0, until: Int = bytes.size) {
        var at = from
        if (bag == null && wpilog == null) {
            while (at < until && seen < beginning.size) beginning[seen++] = bytes[at++]
            if (seen < beginning.size) return
            choose()
        }
        give(bytes, at, until)
    }

    /** Says that the file has ended, and returns what was read. To be called once, last. */
    public fun finish(): Recording {
        if (bag == null && wpilog == null) choose()
        return bag?.finish() ?: checkNotNull(wpilog).finish()
    }

    private fun choose() {
        if (FileSignature.of(beginning, seen) == FileSignature.WPILOG) {
            wpilog = WpilogParser(keepSamples)
        } else {
            bag = BagParser(expectedBytes, keepSamples)
        }
        give(beginning, 0, seen)
    }

    private fun give(bytes: ByteArray, from: Int, until: Int) {
        bag?.accept(bytes, from, until)
        wpilog?.accept(bytes, from, until)
    }
}
