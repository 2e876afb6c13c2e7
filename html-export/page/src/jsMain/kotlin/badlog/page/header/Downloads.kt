package badlog.page.header

import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.saveFile
import badlog.page.embedded.About
import badlog.page.embedded.CsvPart
import badlog.page.embedded.EmbeddedFile
import badlog.page.embedded.EmbeddedLog
import badlog.page.embedded.LogBytes
import badlog.page.export.fileOf
import badlog.page.view.Notice
import badlog.viewer.shown.table.CsvDraft
import kotlinx.browser.document
import org.w3c.dom.HTMLElement
import org.w3c.dom.asList
import org.w3c.files.Blob
import kotlin.js.Promise

/**
 * The buttons that save files: the original, byte for byte; its samples as CSV; and the page's other files.
 *
 * @param bytes the bytes of the file.
 * @param read the recording read from it.
 * @param isDamaged whether the page was changed since it was exported.
 */
internal class Downloads(private val about: About, private val bytes: LogBytes, private val read: Recording, isDamaged: Boolean = false) {
    private val exactness = if (isDamaged) "as much as this damaged page still has" else "byte for byte"

    /** The notice that shows the progress of longer work. */
    val notice: Notice = Notice()

    val element: HTMLElement = element("div", "downloads") {
        val text = if (about.second == null) "Download" else ending(about.name)
        addDownload("download", Icon.DOWNLOAD, text, "Save ${about.name}, $exactness", about.name) {
            bytes.original().then { if (about.second == null) it else it.slice(0, about.firstBytes ?: 0) }
        }
        about.second?.let { second ->
            addDownload("download-second", Icon.DOWNLOAD, ending(second), "Save $second, $exactness", second) {
                bytes.original().then { it.slice(about.firstBytes ?: 0) }
            }
        }
        val csvName = if (about.name.lowercase().endsWith(".csv")) about.name else "${about.name}.csv"
        addDownload("download-csv", Icon.TABLE, "CSV", "Save the samples for a spreadsheet", csvName) { csv() }
        // Attachments belong to the page's own log.
        val attachments = if (bytes is EmbeddedLog) document.querySelectorAll("script.attachment").asList() else emptyList()
        attachments.forEachIndexed { index, node ->
            val carrier = node.unsafeCast<HTMLElement>()
            val name = carrier.getAttribute("data-name") ?: "attachment ${index + 1}"
            addDownload("attachment-$index", Icon.CLIP, name, "Save the attached $name", name) {
                EmbeddedFile(carrier).inflated()
            }.classList.add("attachment")
        }
    }

    /** Returns the extension, by which the two files of one log differ: `.dslog` and `.dsevents`. */
    private fun ending(name: String): String = ".${name.removeSuffix(".gz").substringAfterLast('.')}"

    /**
     * Returns the file's own text if it has rows and no damage. Otherwise returns the recording, with damaged parts skipped or repaired.
     */
    private fun csv(): Promise<Blob?> {
        val own = if (read.isSalvaged || !read.format.hasRows) null else bytes.text(CsvPart(read.headerLine != null)::filter)
        return own ?: fileOf(CsvDraft.ofAll(LogView.of(read)), notice)
    }

    private fun HTMLElement.addDownload(
        id: String,
        icon: Icon,
        text: String,
        hint: String,
        name: String,
        content: () -> Promise<Blob?>,
    ): HTMLElement {
        val button = addButton("", "", hint) {}
        button.id = id
        button.appendChild(icon.draw())
        button.add("span", "", text)
        button.addEventListener("click", {
            button.setAttribute("aria-busy", "true")
            // Started in a promise, so that an immediate failure is reported, too.
            Promise.resolve(Unit).then { content() }
                .then { if (it != null) saveFile(it, name) }
                .catch { button.textContent = "Could not be saved: ${it.message}" }
                .then { button.removeAttribute("aria-busy") }
        })
        return button
    }
}
