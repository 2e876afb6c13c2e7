package badlog.html

import badlog.html.protocol.PageAdditions
import badlog.html.protocol.inScript
import badlog.html.protocol.toJson
import badlog.json.quotedJson
import java.io.OutputStream

/** Writes a page from its beginning to its end; the functions are to be called in their order here. */
internal class PageWriter(private val out: OutputStream, private val parts: PageParts) {
    /** Everything before the recording. Whether it [hasVideo] beside it is a part of its policy. */
    fun begin(title: String, hasVideo: Boolean = false) {
        text(
            """
            $PAGE_START>
            <html lang="en">
            <head>
            <meta charset="utf-8">
            <meta http-equiv="Content-Security-Policy" content="${parts.policy(hasVideo)}">
            <meta name="viewport" content="width=device-width, initial-scale=1">
            <meta name="generator" content="badlog ${escapeHtml(BADLOG_VERSION)}">
            <title>
            """.trimIndent() + escapeHtml(title) + "</title>\n<style>${parts.waitingStyle}",
        )
        text(
            """
            </style>
            </head>
            <body>
            <noscript><p>$NO_SCRIPT</p></noscript>
            <main id="page"><p class="screen waiting">$WAITING</p></main>

            """.trimIndent(),
        )
    }

    /** What the page shows besides the recording, no byte when that is nothing; then the program, which runs while the rest is loaded. */
    fun program(additions: PageAdditions) {
        val json = additions.toJson()
        if (json != NO_ADDITIONS) {
            text("<script type=\"application/octet-stream\" id=\"packed-additions\">")
            out.write(packed(json))
            text("</script>\n")
        }
        text("<script type=\"application/octet-stream\" id=\"packed\">")
        out.write(parts.packedProgram)
        text("</script>\n<script id=\"unpacking\">$UNPACKING</script>\n")
    }

    /**
     * The recording that came from the file [name]; [embed] gives its gzip stream to the base64 stream.
     *
     * @param lineBytes how long the file is, where each line of the base64 but the first and the last holds some of its rows, which can
     *   be read before the others are there; else null.
     */
    fun <T> recording(name: String, lineBytes: Long?, embed: (Base64Stream) -> T): T {
        val bytes = if (lineBytes == null) "" else " data-bytes=\"$lineBytes\""
        return base64("id=\"recording\" data-name=\"${escapeHtml(name)}\"$bytes", embed)
    }

    /** An attached file with its [name]; [embed] as in [recording]. */
    fun <T> attachment(name: String, embed: (Base64Stream) -> T): T =
        base64("class=\"attachment\" data-name=\"${escapeHtml(name)}\"", embed)

    /** The end, about the recording that came from the file [name], and [second]. A page without it was cut. */
    fun end(name: String, file: EmbeddedFile, isGzip: Boolean, second: SecondPart? = null) {
        val cut = if (file.isCut) ",\"cut\":true" else ""
        val more = if (second == null) "" else ",\"second\":${inScript(quotedJson(second.name))},\"firstBytes\":${second.from}"
        text(
            "<script type=\"application/json\" id=\"about\">{\"name\":${inScript(quotedJson(name))}," +
                "\"original\":\"${if (isGzip) "gzip" else "raw"}\",\"inflatedBytes\":${file.inflatedBytes}$cut$more," +
                "\"version\":${quotedJson(BADLOG_VERSION)}}</script>\n</body>\n</html>\n",
        )
    }

    private fun <T> base64(attributes: String, embed: (Base64Stream) -> T): T {
        text("<script type=\"application/octet-stream\" $attributes>")
        val base64 = Base64Stream(out)
        val result = embed(base64)
        base64.finish()
        text("</script>\n")
        return result
    }

    private fun text(text: String) = out.write(text.encodeToByteArray())

    private companion object {
        val NO_ADDITIONS = PageAdditions().toJson()

        // Until the program runs, or instead.
        const val WAITING = "Loading… If this stays, the file is incomplete: copy it again."
        const val NO_SCRIPT = "This page needs JavaScript to draw its log: allow scripts for this file, or open it in another browser."
    }
}
