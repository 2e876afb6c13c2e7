package badlog.page.formula

import badlog.page.dom.PageEvents
import badlog.page.folder.FolderList
import badlog.page.folder.FolderNavigation
import badlog.page.graph.VisibleGraphs
import badlog.page.view.Notice
import badlog.page.view.PageBoard
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.choices.formula.nameIn
import badlog.viewer.choices.formula.usersOf
import badlog.viewer.state.BoardAction
import kotlinx.browser.window

/**
 * The graphs of the [formulas] in the folders, on the board and on the screen.
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
    private val notice: Notice,
    private val onChange: () -> Unit,
    private val linesNow: () -> BoardLines,
) {
    /** The time when the first slice of a longer calculation ended; NaN if none is running. */
    private var begun = Double.NaN

    init {
        formulas.onProgress = ::showProgress
        formulas.onFailure = { problem ->
            begun = Double.NaN
            notice.say("The formula could not be calculated: ${problem.message}. Close other pages, and try again.")
        }
        PageEvents.onEnd(formulas::cancel)
    }

    /** Adds [definition], which must be valid. */
    fun add(definition: String) {
        onChange()
        formulas.addAll(listOf(definition), isRemembered = true) { mistakes ->
            if (mistakes.isEmpty()) graphs.add(folders.add(formulas.graphOf(definition)))
            list()
        }
    }

    /** Adds the valid [definitions] of a link or a layout, then calls [then] with the reasons why others are skipped. */
    fun addAll(definitions: List<String>, isRemembered: Boolean, then: (List<String>) -> Unit) {
        val others = definitions.filterNot(formulas::has)
        formulas.addAll(others, isRemembered) { mistakes ->
            for (definition in others.filter(formulas::has)) graphs.add(folders.add(formulas.graphOf(definition), isWanted = false))
            if (definitions.isNotEmpty()) list()
            then(mistakes.map { "Skipped “${it.text}”: ${it.message}" })
        }
    }

    /** Replaces the definition [from] with [to], which must be valid. */
    fun change(from: String, to: String) {
        onChange()
        formulas.finish()
        val users = formulas.all.usersOf(from)
        val names = (users + from).mapNotNull(formulas::nameOf)
        formulas.replace(from, to) {
            names.forEach(::removeGraph)
            for (definition in users + to) graphs.add(folders.add(formulas.graphOf(definition)))
            // Done before the old name becomes unknown, because the board drops lines without topics.
            nameIn(to)?.let { board.send(BoardAction.Rename(nameIn(from).orEmpty(), it)) }
            list()
        }
    }

    /** Removes [definition], which no other definition uses. */
    fun remove(definition: String) {
        onChange()
        formulas.finish()
        formulas.nameOf(definition)?.let(::removeGraph)
        formulas.remove(definition)
        nameIn(definition)?.let { board.send(BoardAction.Forget(setOf(it))) }
        list()
    }

    private fun showProgress(share: Double) {
        val now = window.performance.now()
        when {
            share < 1 && begun.isNaN() -> begun = now

            share < 1 -> if (now - begun > PATIENCE) {
                notice.show("Calculating the formulas: ${(share * PERCENT).toInt()} %") {
                    begun = Double.NaN
                    formulas.cancel()
                }
            }

            !begun.isNaN() -> {
                if (now - begun > PATIENCE) notice.endProgress()
                begun = Double.NaN
            }
        }
    }

    private fun list() {
        board.lines = linesNow()
        navigation.list()
    }

    private fun removeGraph(name: String) {
        folders.remove(name)?.let(graphs::remove)
    }
}

/** The milliseconds before progress is shown. */
private const val PATIENCE = 500
private const val PERCENT = 100
