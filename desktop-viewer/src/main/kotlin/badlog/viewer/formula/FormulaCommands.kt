package badlog.viewer.formula

import androidx.compose.ui.input.key.Key
import badlog.viewer.app.Command
import badlog.viewer.app.KeyPress
import badlog.viewer.app.Viewer

/** Opens the sheet for a formula, with [names] of the open recording in it; nothing happens without a recording. */
internal fun writeFormula(viewer: Viewer, names: List<String> = emptyList()) {
    val open = viewer.open ?: return
    val vocabulary = vocabularyFor(open, definition = null)
    val start = if (names.isEmpty()) "" else " = " + names.joinToString(" * ") { nameInExpression(it, vocabulary) }
    viewer.formulaSheet = FormulaSheet(start = start)
}

/** What the keyboard does with formulas. */
internal fun formulaCommands(viewer: Viewer): List<Command> =
    listOf(Command("Topics", "New formula: a topic calculated from others", listOf(NEW_FORMULA)) { writeFormula(viewer) })

internal val NEW_FORMULA = KeyPress(Key.F, "F")
