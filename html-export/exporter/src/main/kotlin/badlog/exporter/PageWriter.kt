package badlog.exporter

import badlog.core.json.quotedJson
import badlog.protocol.PageAdditions
import badlog.protocol.inScript
import badlog.protocol.toJson
import java.io.OutputStream

/** Writes a page from beginning to end. Call the functions in the order in which they are declared. */
internal class PageWriter(private val out: OutputStream, private val parts: PageParts) {
    /**
     * Writes everything before the recording. The policy depends on whether there is a video beside the page, and on the [network] that the
     * page may use.
     */
    fun begin(title: String, hasVideo: Boolean = false, network: PageNetwork = PageNetwork.NONE) {
        text(
            """
            $PAGE_START>
            <html lang="en">
            <head>
            <meta charset="utf-8">
            <meta http-equiv="Content-Security-Policy" content="${parts.policy(hasVideo, network)}">
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

    /** Writes the [additions], if there are any, then the program, which runs while the rest is loading. */
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
     * Writes the recording from the file [name]; [embed] passes its gzip stream to the base64 stream.
     *
     * @param lineBytes the length of the file in bytes if its rows can be read while the page loads; null otherwise. If it is given, each
     * line of the base64 contains some of the rows, except the first and the last.
     */
    fun recording(name: String, lineBytes: Long?, embed: (Base64Stream) -> EmbeddedFile): Embedded {
        val bytes = if (lineBytes == null) "" else " data-bytes=\"$lineBytes\""
        return base64("id=\"recording\" data-name=\"${escapeHtml(name)}\"$bytes", embed)
    }

    /** Writes an attached file with its [name]; [embed] as in [recording]. */
    fun attachment(name: String, embed: (Base64Stream) -> EmbeddedFile): Embedded =
        base64("class=\"attachment\" data-name=\"${escapeHtml(name)}\"", embed)

    /** Writes a file of a compared log with its [name]; [embed] as in [recording]. */
    fun compared(name: String, embed: (Base64Stream) -> EmbeddedFile): Embedded =
        base64("class=\"compared\" data-name=\"${escapeHtml(name)}\"", embed)

    /** Writes the log from the file [name] as the sample of a page without a recording; [embed] as in [recording]. */
    fun sample(name: String, embed: (Base64Stream) -> EmbeddedFile): Embedded =
        base64("id=\"sample\" data-name=\"${escapeHtml(name)}\"", embed)

    /** Writes the end of a page without a recording, which may use [network]. */
    fun end(network: PageNetwork) {
        val word = network.word?.let { ",\"network\":\"$it\"" }.orEmpty()
        val about = "{\"version\":${quotedJson(BADLOG_VERSION)}$word}"
        text("<script type=\"application/json\" id=\"about\">$about</script>\n</body>\n</html>\n")
    }

    /**
     * Writes the end of a page, with facts about the recording. [name] is the name of the recording's file, [second] the log's second file
     * if there is one. A page without this end is incomplete.
     */
    fun end(name: String, embedded: Embedded, isGzip: Boolean, second: SecondPart? = null) {
        val file = embedded.file
        val cut = if (file.isCut) ",\"cut\":true" else ""
        val more = if (second == null) "" else ",\"second\":${inScript(quotedJson(second.name))},\"firstBytes\":${second.from}"
        text(
            "<script type=\"application/json\" id=\"about\">{\"name\":${inScript(quotedJson(name))}," +
                "\"original\":\"${if (isGzip) "gzip" else "raw"}\",\"inflatedBytes\":${file.inflatedBytes}$cut$more," +
                "\"crc32\":${embedded.lineSums.joinToString(",", "[", "]")}," +
                "\"version\":${quotedJson(BADLOG_VERSION)}}</script>\n</body>\n</html>\n",
        )
    }

    private fun base64(attributes: String, embed: (Base64Stream) -> EmbeddedFile): Embedded {
        text("<script type=\"application/octet-stream\" $attributes>")
        val base64 = Base64Stream(out)
        val file = embed(base64)
        base64.finish()
        text("</script>\n")
        return Embedded(file, base64.lineSums)
    }

    private fun text(text: String) = out.write(text.encodeToByteArray())

    private companion object {
        val NO_ADDITIONS = PageAdditions().toJson()

        // Shown until the program runs, or if it does not run.
        const val WAITING = "Loading… If this stays, the file is incomplete: copy it again."
        const val NO_SCRIPT = "This page needs JavaScript to draw its log: allow scripts for this file, or open it in another browser."
    }
}
