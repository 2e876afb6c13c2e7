package badlog.bag

import badlog.text.CR
import badlog.text.LF
import badlog.text.NUL

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
