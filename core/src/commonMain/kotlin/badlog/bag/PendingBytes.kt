package badlog.bag

import badlog.recording.ProblemKind
import badlog.recording.ProblemList
import badlog.text.CR
import badlog.text.LF
import badlog.text.NUL

/** What of a file has arrived and is not read yet: [bytes] from [start] until [end]. */
internal class PendingBytes(room: Int = 2 * PIECE) {
    var bytes = ByteArray(room)
        private set
    var start = 0
        private set
    var end = 0
        private set

    /** Behind the last line end, or NUL, that has arrived. */
    var lineEnd = 0
        private set

    /** The physical line, from 1, that [start] is in. */
    var line = 1

    /** The line on which a run of NULs was skipped last; 0 before any. */
    var holeLine = 0

    /** Whether the beginning of the line that [start] is in was lost in a run of NULs. */
    val isAfterHole: Boolean get() = line == holeLine

    /** Whether a line that was read ended in a carriage return. */
    var sawCarriageReturn = false
        private set

    /** How many bytes have been read before [start]. */
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

    /** Takes the bytes from [from] until [until] of [others] for a file of its own, without a copy. Not to be appended to. */
    fun lend(others: ByteArray, from: Int, until: Int) {
        bytes = others
        start = from
        end = until
        line = 1
        sawCarriageReturn = false
    }

    /** Says that what [batch] was read from came and is read. */
    fun pass(batch: RowBatch) {
        passed += batch.byteCount
        line += batch.lineCount
        if (batch.sawCarriageReturn) sawCarriageReturn = true
    }

    /** Says that all before [next] is read. */
    fun advanceTo(next: Int) {
        if (next - start >= 1 && bytes[next - 1].toInt() == CR) sawCarriageReturn = true
        if (next - start >= 2 && bytes[next - 2].toInt() == CR && bytes[next - 1].toInt() == LF) sawCarriageReturn = true
        passed += next - start
        start = next
    }

    /**
     * Passes the blank line that ends at [end], before [next], and all that follow it as far as they have arrived: there may be a
     * billion. Returns where they end, and reports them.
     */
    fun passBlankLines(end: Int, next: Int, problems: ProblemList): Int {
        var at = next
        val size = next - end
        if (size == 2) {
            while (at + 1 < this.end && bytes[at].toInt() == CR && bytes[at + 1].toInt() == LF) at += 2
        } else if (bytes[end].toInt() == LF) {
            while (at < this.end && bytes[at].toInt() == LF) at++
        }
        val count = (at - end) / size
        for (i in (if (isAfterHole) 1 else 0) until minOf(count, FEW)) problems.add(ProblemKind.BLANK_LINE, BLANK, line + i)
        if (count > FEW) problems.add(ProblemKind.BLANK_LINE, BLANK, line + FEW, count = count - FEW)
        line += count
        return at
    }

    companion object {
        private const val BLANK = "A blank line was skipped."
        private const val FEW = 10

        /** How much is read at a time: enough to be fast, little enough to stay in the processor's cache. */
        const val PIECE = 1 shl 16
    }
}

/** Where the line that [from] is in ends: at its LF or CR, or at a NUL, where whatever stood there is lost; else [until]. */
internal fun lineEndIn(bytes: ByteArray, from: Int, until: Int): Int {
    var at = from
    while (at < until && !isLineEnd(bytes[at].toInt())) at++
    return at
}

internal fun isLineEnd(byte: Int): Boolean = byte == LF || byte == CR || byte == NUL

/**
 * Where the line after the one that ends at [end] begins; for a NUL that is the NUL itself.
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
