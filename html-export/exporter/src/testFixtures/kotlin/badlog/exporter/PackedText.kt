package badlog.exporter

import java.io.ByteArrayOutputStream
import java.nio.file.Path
import java.util.zip.GZIPInputStream
import kotlin.io.path.readText

/** Returns what [page] carries besides the log, as JSON; empty for nothing. */
internal fun additionsIn(page: Path): String = page.readText().substringAfter("id=\"packed-additions\">", "").substringBefore('<').let { if (it.isEmpty()) "" else unpacked(it) }

/** Returns what the page's own script makes of [text]: the text of a gzip stream to the base 122. */
internal fun unpacked(text: String): String = GZIPInputStream(ofBase122(text).inputStream()).readAllBytes().decodeToString()

/** Returns the bytes that [text] has to the base 122, read the way of the page's own script. */
internal fun ofBase122(text: String): ByteArray {
    val digits = text.map { VALUES.getValue(it.code) }
    val bytes = ByteArrayOutputStream()
    var bits = 0
    var count = 0
    for (pair in digits.chunked(2)) {
        val number = pair[0] + pair.getOrElse(1) { 0 } * 122
        bits = bits or (number shl count)
        count += if (pair.size == 1) {
            8 - count
        } else if (number % 8192 > 6691) {
            13
        } else {
            14
        }
        while (count > 7) {
            bytes.write(bits)
            bits = bits ushr 8
            count -= 8
        }
    }
    return bytes.toByteArray()
}

private val VALUES: Map<Int, Int> =
    (1..127).filter { it !in listOf(12, 13, 26, 27, 60) }.withIndex().associate { (value, code) -> code to value }
