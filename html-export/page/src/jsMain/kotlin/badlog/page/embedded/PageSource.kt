package badlog.page.embedded

import badlog.rules.RuleSet
import badlog.rules.toJson
import badlog.viewer.choices.note.NoteHistory
import badlog.viewer.choices.note.toJson
import badlog.viewer.choices.note.toLines
import kotlinx.browser.document
import org.w3c.dom.Element
import org.w3c.dom.asList
import org.w3c.files.Blob
import org.w3c.files.File
import kotlin.js.Promise

/**
 * The text of this page as it was exported, for a copy. The document still contains all of it: the program, which the page's policy
 * requires letter for letter, and the log.
 *
 * @param root the element that the program fills; still as it was exported.
 */
internal class PageSource(root: Element) {
    private val waiting = root.outerHTML

    /**
     * Returns a copy of this page with [notes] and with [layout], the text of a layout file. Fails if the page's own additions are damaged.
     *
     * @param rules the rules, if the page's reader has changed them; null for the page's own.
     * @param opened the markup of a log that replaces the page's own, see [LogBytes.toMarkup]; null for the page's own.
     * @param compared the files of the logs that are compared with it.
     * @param removed the files of logs that are no longer compared; the other compared logs in the page are copied unchanged.
     */
    fun copyWith(
        notes: NoteHistory,
        layout: String,
        rules: RuleSet?,
        opened: Promise<Blob>?,
        compared: List<File>,
        removed: List<File>,
    ): Promise<Blob> {
        val additions = JSON.parse<dynamic>(document.getElementById("additions")?.textContent ?: NO_ADDITIONS)
        additions.notes = JSON.parse<dynamic>(notes.unchanged.toJson())
        additions.noteLines = notes.changes.toLines()
        additions.notesProblem = undefined
        additions.layout = layout
        if (rules != null) additions.rules = JSON.parse<dynamic>(rules.toJson())
        if (opened != null) {
            for (list in listOf("virtual", "findings", "hooks")) additions[list] = emptyArray<Any>()
            for (one in listOf("differences", "video")) additions[one] = undefined
        }
        val text = packed(Blob(arrayOf(JSON.stringify(additions)))).then { bytesOf(it, 0.0, it.size.toDouble()) }.then { base64(it) }
        val others = compared.filter { opened != null || it.carrier == null }.map(::markupOfCompared)
        val parts = Promise.all(arrayOf<Promise<Any?>>(text, opened ?: Promise.resolve(null), Promise.all(others.toTypedArray())))
        return parts.then { (packed, log, more) ->
            copyWith(packed as String, log as Blob?, more.unsafeCast<Array<Blob>>(), removed.mapNotNull { it.carrier })
        }
    }

    private fun copyWith(additions: String, opened: Blob?, compared: Array<Blob>, removed: List<Element>): Blob {
        val copy = BlobParts()
        copy.add("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n")
        // The program and its style come after the page's first style element.
        val head = checkNotNull(document.head).children.asList()
        // A copy is a file, which never uses a network, wherever the page came from.
        for (element in head.take(head.indexOfFirst { it.tagName == "STYLE" } + 1)) copy.add(element.outerHTML.replace(NETWORK, "") + "\n")
        copy.add("</head>\n<body>\n")
        for (element in checkNotNull(document.body).children.asList()) {
            when {
                element.tagName == "NOSCRIPT" -> copy.add(element.outerHTML + "\n")

                element.tagName == "MAIN" -> copy.add("$waiting\n")

                element.tagName != "SCRIPT" || element.id == "additions" -> Unit

                opened != null && element.id !in PROGRAM -> Unit

                element in removed -> Unit

                else -> {
                    if (element.id == "packed") copy.addAdditions(additions)
                    // The facts about the log end a page.
                    if (element.id == "about") compared.forEach(copy::add)
                    copy.addScript(element)
                }
            }
        }
        if (opened != null) {
            compared.forEach(copy::add)
            copy.add(opened)
        }
        copy.add("</body>\n</html>\n")
        return copy.toBlob()
    }

    private fun BlobParts.addAdditions(packed: String) =
        add("<script type=\"application/octet-stream\" id=\"packed-additions\">$packed$END\n")

    /** Adds [script] text node by text node. Its text may be hundreds of megabytes long. */
    private fun BlobParts.addScript(script: Element) {
        add(script.cloneNode(false).unsafeCast<Element>().outerHTML.removeSuffix(END))
        var node = script.firstChild
        while (node != null) {
            add(node.nodeValue.orEmpty())
            node = node.nextSibling
        }
        add("$END\n")
    }

    private companion object {
        /** The scripts of a page that do not depend on its log. */
        val PROGRAM = setOf("packed", "unpacking")

        /** The part of the policy that allows a served page to use the network. */
        val NETWORK = Regex("connect-src [^;]*; ")

        const val NO_ADDITIONS = """{"virtual":[],"findings":[],"hooks":[]}"""
    }
}
