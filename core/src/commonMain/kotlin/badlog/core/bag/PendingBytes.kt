package badlog.core.bag

import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.text.CR
import badlog.core.text.LF
import badlog.core.text.NUL

/** The bytes of a file that have arrived but are not read yet: [bytes] from [start] until [end]. */
internal class PendingBytes(room: Int = 2 * PIECE) {
    var bytes = ByteArray(room)
        private set
    var start = 0
        private set
    var end = 0
        private set

    /** The position after the last line end, or NUL, that has arrived. */
    var lineEnd = 0
        private set

    /** The physical line that [start] is in, counted from 1. */
    var line = 1

    /** The line on which a run of NULs was last skipped; 0 if there was none. */
    var holeLine = 0

    /** Whether the beginning of the line that [start] is in was lost in a run of NULs. */
    val isAfterHole: Boolean get() = line == holeLine

    /** Whether a line that was read ended in a carriage return. */
    var sawCarriageReturn = false
        private set

    /** The number of bytes read before [start]. */
    var passed = 0L
        private set

    val size: Int get() = end - start

    fun append(more: ByteArray, from: Int, until: Int) {
        if (end + until - from > bytes.size) {
            bytes.copyInto(bytes, 0, start, end)
            end -= start
            lineEnd -= start
            start = 0
            if (end + until - from > bytes.size) bytes = bytes.copyOf((end + until - from) * 2)
        }
        more.copyInto(bytes, end, from, until)
        var at = end + until - from
        while (at > end && !isLineEnd(bytes[at - 1].toInt())) at--
        if (at > end) lineEnd = at
        end += until - from
    }

    /** Replaces all bytes that have arrived by their [translation]. */
    fun translate(translation: CsvTranslation) {
        translation.accept(bytes, start, end)
        end = start
        lineEnd = start
        append(translation.out, 0, translation.outSize)
    }

    /** Appends the [translation] of the file's last bytes. */
    fun finish(translation: CsvTranslation) {
        translation.finish()
        append(translation.out, 0, translation.outSize)
    }

    /** Treats the bytes from [from] until [until] of [others] as a separate file, without copying them. Nothing may be appended. */
    fun lend(others: ByteArray, from: Int, until: Int) {
        bytes = others
        start = from
        end = until
        line = 1
        sawCarriageReturn = false
    }

    /** Counts the bytes and lines of [batch] as read, without appending them. */
    fun pass(batch: RowBatch) {
        passed += batch.byteCount
        line += batch.lineCount
        if (batch.sawCarriageReturn) sawCarriageReturn = true
    }

    /** Marks everything before [next] as read. */
    fun advanceTo(next: Int) {
        if (next - start >= 1 && bytes[next - 1].toInt() == CR) sawCarriageReturn = true
        if (next - start >= 2 && bytes[next - 2].toInt() == CR && bytes[next - 1].toInt() == LF) sawCarriageReturn = true
        passed += next - start
        start = next
    }

    /**
     * Skips the blank line that ends at [end], before [next], and all blank lines after it that have arrived. Reports them, and returns
     * where they end. There may be a billion of them.
     */
    fun skipBlankLines(end: Int, next: Int, problems: ProblemList): Int {
        var at = next
        val size = next - end
        if (size == 2) {
            while (at + 1 < this.end && bytes[at].toInt() == CR && bytes[at + 1].toInt() == LF) at += 2
        } else if (bytes[end].toInt() == LF) {
            while (at < this.end && bytes[at].toInt() == LF) at++
        }
        val count = (at - end) / size
        for (i in (if (isAfterHole) 1 else 0) until minOf(count, MAX_LISTED)) problems.add(ProblemKind.BLANK_LINE, BLANK, line + i)
        if (count > MAX_LISTED) problems.add(ProblemKind.BLANK_LINE, BLANK, line + MAX_LISTED, count = count - MAX_LISTED)
        line += count
        return at
    }

    companion object {
        private const val BLANK = "A blank line was skipped."
        private const val MAX_LISTED = 10

        /** The number of bytes read at a time: enough to be fast, few enough to stay in the processor's cache. */
        const val PIECE = 1 shl 16
    }
}

/**
 * Returns the end of the line that contains [from]. It is its LF or CR, or a NUL, where the original content is lost. Returns [until] if
 * there is none.
 */
internal fun lineEndIn(bytes: ByteArray, from: Int, until: Int): Int {
    var at = from
    while (at < until && !isLineEnd(bytes[at].toInt())) at++
    return at
}

internal fun isLineEnd(byte: Int): Boolean = byte == LF || byte == CR || byte == NUL

/**
 * Returns where the line after the one that ends at [end] begins; for a NUL, that is the NUL itself.
 *
 * @param isEnd whether no bytes will follow those before [until].
 * @return [RowScanner.INCOMPLETE] for a CR that may be half of a CRLF.
 */
internal fun afterLineEnd(bytes: ByteArray, end: Int, until: Int, isEnd: Boolean): Int = when {
    end == until || bytes[end].toInt() == NUL -> end
    bytes[end].toInt() == LF -> end + 1
    end + 1 < until -> if (bytes[end + 1].toInt() == LF) end + 2 else end + 1
    isEnd -> end + 1
    else -> RowScanner.INCOMPLETE
}
