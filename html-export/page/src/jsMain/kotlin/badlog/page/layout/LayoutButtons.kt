package badlog.page.layout

import badlog.page.dom.Icon
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.saveFile
import badlog.page.view.Notice
import badlog.viewer.choices.board.BoardException
import badlog.viewer.choices.board.BoardLayout
import badlog.viewer.choices.board.boardLayoutOf
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement
import org.w3c.files.Blob
import org.w3c.files.BlobPropertyBag
import org.w3c.files.File
import kotlin.js.Promise

/**
 * The buttons that save the board as a layout file and open one. The window uses the same files.
 *
 * @param name the log's name.
 * @param layoutNow returns the layout to save.
 * @param dialog stores layouts by name in the browser.
 * @param onOpen called with the opened layout.
 */
internal class LayoutButtons(
    private val name: String,
    private val notice: Notice,
    private val layoutNow: () -> BoardLayout,
    private val dialog: LayoutDialog,
    private val onOpen: (BoardLayout) -> Unit,
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
        addIconButton("", Icon.LAYOUT, "Layouts: keep this board, or go to another") { dialog.open() }.id = "layouts"
        addIconButton("", Icon.DOWNLOAD, "Download layout") { save() }.id = "download-layout"
        addIconButton("", Icon.FOLDER, "Open a layout, or drop it on the page") { input.click() }.id = "open-layout"
        appendChild(input)
    }

    private fun save() = saveFile(Blob(arrayOf(layoutNow().toJson()), BlobPropertyBag("application/json")), name + BoardLayout.ENDING)

    /** Opens [file] if it is a layout. Returns false otherwise. */
    fun open(file: File): Boolean {
        val isLayout = file.name.endsWith(".json", ignoreCase = true)
        if (isLayout) read(file)
        return isLayout
    }

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
