package badlog.html

import java.io.ByteArrayOutputStream
import java.nio.file.Path
import java.util.zip.GZIPInputStream
import kotlin.io.path.readText

/** What [page] carries besides the log, as JSON; empty for nothing. */
internal fun additionsIn(page: Path): String = page.readText().substringAfter("id=\"packed-additions\">", "").substringBefore('<').let { if (it.isEmpty()) "" else unpacked(it) }

/** What the page's own script makes of [text]: the text of a gzip stream in base 94. */
internal fun unpacked(text: String): String {
    val digits = text.map { (if (it == '~') '<' else it) - ' ' }
    val gzip = ByteArrayOutputStream()
    var bits = 0
    var count = 0
    for (pair in digits.chunked(2)) {
        val number = pair[0] + pair.getOrElse(1) { 0 } * 94
        bits = bits or (number shl count)
        count += if (pair.size == 1) {
            8 - count
        } else if (number % 8192 > 643) {
            13
        } else {
            14
        }
        while (count > 7) {
            gzip.write(bits)
            bits = bits ushr 8
            count -= 8
        }
    }
    return GZIPInputStream(gzip.toByteArray().inputStream()).readAllBytes().decodeToString()
}
