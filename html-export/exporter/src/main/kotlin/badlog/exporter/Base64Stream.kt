package badlog.exporter

import java.io.OutputStream
import java.util.Base64

/**
 * Writes bytes to [out] as base64, however they are split into pieces: one or two bytes that do not fill a group of three wait for the
 * next piece, so that padding is only at the end of a line. Lines end only where [endLine] is called.
 */
internal class Base64Stream(private val out: OutputStream) {
    private val encoder = Base64.getEncoder()
    private val source = ByteArray(3 * GROUPS)
    private val text = ByteArray(4 * GROUPS)
    private var held = 0

    /** Writes the bytes from [from] until [until] of [bytes]. Keeps no reference. */
    fun write(bytes: ByteArray, from: Int = 0, until: Int = bytes.size) {
        var at = from
        while (at < until) {
            val size = minOf(source.size - held, until - at)
            bytes.copyInto(source, held, at, at + size)
            held += size
            at += size
            if (held == source.size) {
                out.write(text, 0, encoder.encode(source, text))
                held = 0
            }
        }
    }

    /** Ends a line, so that it can be decoded without the others. */
    fun endLine() {
        finish()
        out.write('\n'.code)
    }

    /** Writes the rest, with its padding. Call it once, last; it does not close [out]. */
    fun finish() {
        out.write(encoder.encode(source.copyOf(held)))
        held = 0
    }

    private companion object {
        const val GROUPS = 1 shl 14
    }
}
