package badlog.exporter

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64
import java.util.zip.GZIPInputStream

/** Splits a page as a browser would: an element ends at the first text that looks like its end tag. */
internal class ReadPage(file: Path) {
    val html: String = Files.readString(file)
    val title: String = between("<title>", "</title>")
    val policy: String = between("Content-Security-Policy\" content=\"", "\"")
    val waitingStyle: String = between("<style>", "</style>")
    private val packed: String = between("id=\"packed\">", "</script>")
    val unpacking: String = between("<script id=\"unpacking\">", "</script>")
    val about: JsonObject =
        Json.parseToJsonElement(between("<script type=\"application/json\" id=\"about\">", "</script>")).jsonObject

    /** The embedded bytes of the recording, a gzip stream. */
    val recording: ByteArray = decode(between("id=\"recording\"", "</script>").substringAfter('>'))

    /** The attached files, by their escaped names. */
    val attachments: Map<String, ByteArray> = filesOf("attachment")

    /** The files of the compared logs. */
    val compared: Map<String, ByteArray> = filesOf("compared")

    private val parts = unpacked(packed)
    val style: String = parts.substringBefore(SEPARATOR)
    val program: String = parts.substringAfter(SEPARATOR)

    fun inflated(): ByteArray = inflate(recording)

    /** Returns the number of start tags of [name] that a browser finds outside scripts and styles. */
    fun count(name: String): Int = Regex("<$name[ >]").findAll(html.replace(unpacking, "").replace(waitingStyle, "")).count()

    private fun between(start: String, end: String): String {
        val from = html.indexOf(start) + start.length
        check(from >= start.length) { "The page has no $start" }
        return html.substring(from, html.indexOf(end, from))
    }

    private fun filesOf(kind: String) = Regex("class=\"$kind\" data-name=\"([^\"]*)\">([^<]*)</script>")
        .findAll(html).associate { (it.groupValues[1]) to inflate(decode(it.groupValues[2])) }

    private fun decode(text: String) = decodeLines(text)

    private fun inflate(bytes: ByteArray) = GZIPInputStream(ByteArrayInputStream(bytes)).readAllBytes()
}

/** Returns the bytes of [text]; each line of it is separate base64. */
internal fun decodeLines(text: String): ByteArray {
    val bytes = ByteArrayOutputStream()
    for (line in text.split('\n')) bytes.write(Base64.getDecoder().decode(line))
    return bytes.toByteArray()
}
