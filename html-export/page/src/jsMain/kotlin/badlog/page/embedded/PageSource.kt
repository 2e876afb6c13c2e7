package badlog.page.embedded

import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.toJson
import kotlinx.browser.document
import kotlinx.browser.window
import org.khronos.webgl.Uint8Array
import org.w3c.dom.Element
import org.w3c.dom.asList
import org.w3c.fetch.Response
import org.w3c.files.Blob
import kotlin.js.Promise

/**
 * The text of this page as it was exported, for a copy of it. Everything is still in the document: the program, which the page's policy
 * demands letter for letter, and the log.
 *
 * @param root the part of the page that its program fills; still as it was exported.
 */
internal class PageSource(root: Element) {
    private val waiting = root.outerHTML

    /**
     * Returns a copy of this page with [notes] and with [layout], the text of a layout file. Fails if the page's own additions are
     * damaged.
     */
    fun copyWith(notes: List<Note>, layout: String): Promise<Blob> {
        val additions = JSON.parse<dynamic>(document.getElementById("additions")?.textContent ?: NO_ADDITIONS)
        additions.notes = JSON.parse<dynamic>(notes.toJson())
        additions.notesProblem = undefined
        additions.layout = layout
        return packed(JSON.stringify(additions)).then(::copyWith)
    }

    private fun copyWith(additions: String): Blob {
        val copy = BlobParts()
        copy.add("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n")
        // The program and its style follow the style that the page has from the beginning.
        val head = checkNotNull(document.head).children.asList()
        for (element in head.take(head.indexOfFirst { it.tagName == "STYLE" } + 1)) copy.add(element.outerHTML + "\n")
        copy.add("</head>\n<body>\n")
        for (element in checkNotNull(document.body).children.asList()) {
            when {
                element.tagName == "NOSCRIPT" -> copy.add(element.outerHTML + "\n")

                element.tagName == "MAIN" -> copy.add("$waiting\n")

                element.tagName != "SCRIPT" || element.id == "additions" -> Unit

                else -> {
                    if (element.id == "packed") copy.addAdditions(additions)
                    copy.addScript(element)
                }
            }
        }
        copy.add("</body>\n</html>\n")
        return copy.toBlob()
    }

    private fun BlobParts.addAdditions(packed: String) =
        add("<script type=\"application/octet-stream\" id=\"packed-additions\">$packed$END\n")

    /** Adds [script], whose text may be hundreds of megabytes long, text node by text node. */
    private fun BlobParts.addScript(script: Element) {
        add(script.cloneNode(false).unsafeCast<Element>().outerHTML.removeSuffix(END))
        var node = script.firstChild
        while (node != null) {
            add(node.nodeValue.orEmpty())
            node = node.nextSibling
        }
        add("$END\n")
    }

    /** Returns the gzip stream of [text] in base64, see `UNPACKING` of the exporter. */
    private fun packed(text: String): Promise<String> {
        val stream = Blob(arrayOf(text)).asDynamic().stream().pipeThrough(js("new CompressionStream('gzip')"))
        return Response(stream).arrayBuffer().then { buffer ->
            val bytes = Uint8Array(buffer)
            (0 until bytes.length step PIECE).joinToString("") { from ->
                val piece = bytes.subarray(from, minOf(from + PIECE, bytes.length))
                window.btoa(js("String").fromCharCode.apply(null, piece).unsafeCast<String>())
            }
        }
    }

    private companion object {
        const val END = "</script>"

        /** A multiple of three, so that the pieces are one base64 text. */
        const val PIECE = 24_576
        const val NO_ADDITIONS = """{"virtual":[],"findings":[],"hooks":[]}"""
    }
}
