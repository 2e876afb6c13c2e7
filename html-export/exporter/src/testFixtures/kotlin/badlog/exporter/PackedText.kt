package badlog.exporter

import java.nio.file.Path
import java.util.Base64
import java.util.zip.GZIPInputStream
import kotlin.io.path.readText

/** Returns the additions of [page] as JSON; empty if there are none. */
internal fun additionsIn(page: Path): String = page.readText().substringAfter("id=\"packed-additions\">", "").substringBefore('<').let { if (it.isEmpty()) "" else unpacked(it) }

/** Returns the unpacked form of [text], a gzip stream in base64, as in the page's own script. */
internal fun unpacked(text: String): String = GZIPInputStream(Base64.getDecoder().decode(text).inputStream()).readAllBytes().decodeToString()
