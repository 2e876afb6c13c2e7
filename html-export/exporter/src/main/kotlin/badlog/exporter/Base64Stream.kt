package badlog.exporter

import java.io.OutputStream
import java.util.Base64
import java.util.zip.CRC32

/**
 * Writes bytes to [out] as base64, regardless of how they are split into pieces. One or two bytes that do not fill a group of three wait
 * for the next piece, so that padding is only at the end of a line. Lines end only where [endLine] is called.
 *
 * It also calculates the CRC-32 of each line's bytes, so that the page can detect changes.
 */
internal class Base64Stream(private val out: OutputStream) {
    private val encoder = Base64.getEncoder()
    private val source = ByteArray(3 * GROUPS)
    private val text = ByteArray(4 * GROUPS)
    private var held = 0
    private val crc = CRC32()
    private val sums = ArrayList<Int>()

    /** The CRC-32 of the bytes of each complete line. */
    val lineSums: List<Int> get() = sums

    /** Writes [bytes] from index [from] until [until]; keeps no reference to the array. */
    fun write(bytes: ByteArray, from: Int = 0, until: Int = bytes.size) {
        crc.update(bytes, from, until - from)
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

    /** Writes the rest of the last line, with its padding. Call it once, last; it does not close [out]. */
    fun finish() {
        out.write(encoder.encode(source.copyOf(held)))
        held = 0
        sums += crc.value.toInt()
        crc.reset()
    }
}

private const val GROUPS = 1 shl 14
