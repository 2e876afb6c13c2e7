package badlog.page.header

import badlog.page.dom.Icon
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.saveFile
import badlog.page.view.Notice
import badlog.viewer.choices.board.BoardException
import badlog.viewer.choices.board.BoardLayout
import badlog.viewer.choices.board.boardLayoutOf
import kotlinx.browser.document
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement
import org.w3c.files.Blob
import org.w3c.files.BlobPropertyBag
import org.w3c.files.File
import kotlin.js.Promise

/**
 * The buttons that save the board to a layout file and open one; the window uses the same files. A layout file dropped on the page is
 * opened, too.
 *
 * @param name the log's name.
 * @param layoutNow returns what to save.
 * @param onOpen called with the opened layout.
 * @param openOther opens a dropped file that is not a layout; returns false if it cannot.
 */
internal class LayoutButtons(
    private val name: String,
    private val notice: Notice,
    private val layoutNow: () -> BoardLayout,
    private val onOpen: (BoardLayout) -> Unit,
    private val openOther: (File) -> Boolean,
) {
    private val input = element("input").unsafeCast<HTMLInputElement>().apply {
        type = "file"
        id = "layout-file"
        accept = ".json"
        isHidden = true
        setAttribute("aria-label", "Layout file")
        addEventListener("change", {
            files?.item(0)?.let(::read)
            value = ""
        })
    }

    val element: HTMLElement = element("div", "graph-tools") {
        addIconButton("", Icon.DOWNLOAD, "Download layout") { save() }.id = "download-layout"
        addIconButton("", Icon.FOLDER, "Open a layout, or drop it on the page") { input.click() }.id = "open-layout"
        appendChild(input)
    }

    init {
        document.addEventListener("dragover", { event -> if (hasFile(event)) event.preventDefault() })
        document.addEventListener("drop", { event ->
            if (!hasFile(event)) return@addEventListener
            event.preventDefault()
            event.asDynamic().dataTransfer.files[0].unsafeCast<File?>()?.let { if (!openOther(it)) read(it) }
        })
    }

    private fun hasFile(event: dynamic): Boolean = event.dataTransfer?.types?.includes("Files") == true

    private fun save() = saveFile(Blob(arrayOf(layoutNow().toJson()), BlobPropertyBag("application/json")), name + BoardLayout.ENDING)

    private fun read(file: File) {
        file.asDynamic().text().unsafeCast<Promise<String>>().then { text ->
            try {
                onOpen(boardLayoutOf(file.name, text))
            } catch (e: BoardException) {
                notice.say(e.message.orEmpty())
            }
        }.catch { notice.say("${file.name} cannot be read; try again.") }
    }
}
