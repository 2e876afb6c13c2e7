package badlog.page.layout

import badlog.page.dom.Icon
import badlog.page.dom.LocalStorage
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.fileInput
import badlog.page.dom.saveFile
import badlog.page.formula.FormulaGraphs
import badlog.page.formula.Formulas
import badlog.page.view.Notice
import badlog.page.view.Scene
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardException
import badlog.viewer.choices.board.BoardLayout
import badlog.viewer.choices.board.boardLayoutOf
import badlog.viewer.choices.board.fittedTo
import badlog.viewer.choices.formula.nameIn
import badlog.viewer.state.BoardAction
import badlog.viewer.state.PlaceAction
import org.w3c.dom.HTMLElement
import org.w3c.files.Blob
import org.w3c.files.BlobPropertyBag
import org.w3c.files.File
import kotlin.js.Promise

/**
 * The board with the formulas as a layout, for storing, downloading, opening and switching.
 *
 * @param log the name of the log's file.
 * @param startBoard returns the graphs with which the log begins.
 * @param onOpen called when a layout is shown.
 */
internal class PageLayouts(
    private val scene: Scene,
    private val formulas: Formulas,
    private val graphs: FormulaGraphs,
    log: String,
    private val startBoard: () -> Board,
    private val onOpen: () -> Unit,
) {
    private val board = scene.board

    val dialog: LayoutDialog = LayoutDialog(KeptLayouts(), scene.notice, ::now, ::switchTo)

    val buttons: LayoutButtons = LayoutButtons(log, scene.notice, ::now, dialog) { open(it, "Opened the layout.") }

    /** Returns the current view as a layout. */
    fun now(): BoardLayout = BoardLayout(board.now, scene.range.now.takeIf { scene.range.isZoomed }, formulas.own)

    private fun switchTo(layout: BoardLayout, name: String) {
        val others = layout.formulas.filter { nameIn(it) !in formulas.names }
        open(BoardLayout(layout.board, formulas = others), "Layout “$name”.")
    }

    private fun open(opened: BoardLayout, said: String) {
        graphs.addAll(opened.formulas, isRemembered = true) { problems ->
            val fitted = opened.board?.fittedTo { board.lines[it] != null }
            board.send(BoardAction.Show(fitted?.board ?: startBoard()))
            opened.visible?.let { wanted -> scene.store.send(PlaceAction.Show(wanted.from, wanted.to)) }
            scene.notice.say(*(problems + (fitted?.sentence ?: said)).toTypedArray())
            onOpen()
        }
    }
}

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
    private val input = fileInput("layout-file", "Layout file", ".json") { it.firstOrNull()?.let(::read) }

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

/**
 * The layouts that the browser stores by name, for all logs and pages. Each is stored separately, so that two tabs do not overwrite each
 * other's layouts.
 */
internal class KeptLayouts {
    /** The name of the layout that was shown or stored last; null if there is none. */
    var shown: String? = null

    /** The names of the stored layouts, in alphabetical order. */
    val names: List<String> get() = LocalStorage.keys(KEY).map { it.removePrefix(KEY) }.sortedBy { it.lowercase() }

    /** Returns the layout named [name]; null if it was removed or cannot be read. */
    operator fun get(name: String): BoardLayout? = try {
        LocalStorage[KEY + name]?.let { boardLayoutOf(name, it) }
    } catch (_: BoardException) {
        null
    }

    /** Stores [layout] as [name] and replaces a layout of that name. Returns false if the browser forbids it or has no room. */
    fun keep(name: String, layout: BoardLayout): Boolean {
        val text = BoardLayout(layout.board, formulas = layout.formulas).toJson()
        LocalStorage[KEY + name] = text
        val isKept = LocalStorage[KEY + name] == text
        if (isKept) shown = name
        return isKept
    }

    /** Removes the layout named [name]. */
    fun remove(name: String) {
        LocalStorage.remove(KEY + name)
        if (shown == name) shown = null
    }
}

private const val KEY = "layout:"
