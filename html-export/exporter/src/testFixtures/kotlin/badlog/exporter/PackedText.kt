package badlog.exporter

import java.nio.file.Path
import java.util.Base64
import java.util.zip.GZIPInputStream
import kotlin.io.path.readText

/** Returns what [page] carries besides the log, as JSON; empty for nothing. */
internal fun additionsIn(page: Path): String = page.readText().substringAfter("id=\"packed-additions\">", "").substringBefore('<').let { if (it.isEmpty()) "" else unpacked(it) }

/** Returns what the page's own script makes of [text]: the text of a gzip stream in base64. */
internal fun unpacked(text: String): String = GZIPInputStream(Base64.getDecoder().decode(text).inputStream()).readAllBytes().decodeToString()
