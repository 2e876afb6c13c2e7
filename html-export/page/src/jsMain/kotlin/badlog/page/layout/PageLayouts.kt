package badlog.page.layout

import badlog.page.formula.FormulaGraphs
import badlog.page.formula.Formulas
import badlog.page.view.Scene
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardLayout
import badlog.viewer.choices.board.fittedTo
import badlog.viewer.choices.formula.nameIn
import badlog.viewer.state.BoardAction
import badlog.viewer.state.PlaceAction

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
