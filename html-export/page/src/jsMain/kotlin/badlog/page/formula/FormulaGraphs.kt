package badlog.page.formula

import badlog.page.folder.FolderList
import badlog.page.folder.FolderNavigation
import badlog.page.graph.VisibleGraphs
import badlog.page.view.PageBoard
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.choices.formula.nameIn
import badlog.viewer.choices.formula.usersOf

/**
 * The graphs of the [formulas] among all others: in the folders, on the board, on the screen.
 *
 * @param onChange called before the reader's formulas change.
 * @param linesNow returns all lines that can be drawn.
 */
internal class FormulaGraphs(
    private val formulas: Formulas,
    private val board: PageBoard,
    private val graphs: VisibleGraphs,
    private val folders: FolderList,
    private val navigation: FolderNavigation,
    private val onChange: () -> Unit,
    private val linesNow: () -> BoardLines,
) {
    /** Adds [definition], which has no mistake. */
    fun add(definition: String) {
        onChange()
        graphs.add(folders.add(formulas.add(definition)))
        list()
    }

    /** Adds those of [definitions], from a link or a layout, that can be calculated here. Returns sentences that say why others cannot. */
    fun addAll(definitions: List<String>, isRemembered: Boolean): List<String> {
        val problems = ArrayList<String>()
        for (definition in definitions.filter { !formulas.has(it) }) {
            val mistake = formulas.mistakeIn(definition)
            if (mistake != null) problems += "Skipped “$definition”: ${mistake.message}"
            if (mistake == null) graphs.add(folders.add(formulas.add(definition, isRemembered), isWanted = false))
        }
        if (definitions.isNotEmpty()) list()
        return problems
    }

    /** Replaces the definition [from] by [to], which has no mistake. */
    fun change(from: String, to: String) {
        onChange()
        val users = formulas.all.usersOf(from)
        for (definition in users + from) removeGraph(definition)
        formulas.replace(from, to)
        for (definition in users + to) graphs.add(folders.add(formulas.graphOf(definition)))
        // Before the old name becomes unknown, because the board drops what nothing draws.
        nameIn(to)?.let { name -> board.change { renamed(nameIn(from).orEmpty(), name) } }
        list()
    }

    /** Removes [definition], which no other one uses. */
    fun remove(definition: String) {
        onChange()
        removeGraph(definition)
        formulas.remove(definition)
        nameIn(definition)?.let { name -> board.change { withoutSignal(name) } }
        list()
    }

    private fun list() {
        board.lines = linesNow()
        navigation.list()
    }

    private fun removeGraph(definition: String) {
        formulas.nameOf(definition)?.let(folders::remove)?.let(graphs::remove)
    }
}
