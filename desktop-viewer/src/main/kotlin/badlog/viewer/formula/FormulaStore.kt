package badlog.viewer.formula

import androidx.compose.runtime.snapshotFlow
import badlog.expression.LogViewSignals
import badlog.expression.signals.Vocabulary
import badlog.plot.formula.nameIn
import badlog.plot.formula.nameInExpression
import badlog.viewer.app.Viewer
import badlog.viewer.recording.OpenRecording
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.withContext

/** Calculates the formulas anew in the recordings that are shown, whenever a person has changed them. */
internal class FormulaKeeping(private val viewer: Viewer) {
    /** Follows the window until cancelled. */
    suspend fun keep() = snapshotFlow { Shown(viewer.formulas, viewer.open, viewer.comparison.loaded.values.toList()) }
        .collectLatest { (definitions, open, compared) ->
            try {
                if (open != null && open.definitions != definitions) {
                    val changed = calculated(open, definitions)
                    viewer.open = changed
                    viewer.comparisonLoading.share(changed)
                }
                for (other in compared) {
                    if (other.file == open?.file || other.definitions == definitions) continue
                    viewer.comparison = viewer.comparison.withLoaded(calculated(other, definitions))
                }
            } catch (_: OutOfMemoryError) {
                viewer.notices.complain("There is not enough memory for the formulas; remove one, or compare fewer logs.")
            }
        }

    private data class Shown(val definitions: List<String>, val open: OpenRecording?, val compared: List<OpenRecording>)

    private suspend fun calculated(recording: OpenRecording, definitions: List<String>) =
        withContext(Dispatchers.Default) { recording.withFormulas(definitions) }
}

/** The names that the definition [definition] of [open] may use: the topics, and the formulas before it; all for null. */
internal fun vocabularyFor(open: OpenRecording, definition: String?): Vocabulary {
    val earlier = open.formulas.takeWhile { it.definition != definition }.mapNotNull { it.topic?.signal }
    val logged = LogViewSignals(open.logged).vocabulary
    return Vocabulary(logged.signals + earlier, logged.hasTime)
}

/** Adds the formula [definition], whose topic is called [name], and draws it. */
internal fun addFormula(viewer: Viewer, definition: String, name: String) {
    viewer.formulas = (viewer.formulas + definition).distinct()
    viewer.graphs = viewer.graphs.withGraph(listOf(name))
}

/** Puts [definition], whose topic is called [name], in the place of the formula [before]; what drew that draws this. */
internal fun changeFormula(viewer: Viewer, before: String, definition: String, name: String) {
    viewer.formulas = viewer.formulas.map { if (it == before) definition else it }.distinct()
    nameIn(before)?.let { viewer.graphs = viewer.graphs.renamed(it, name) }
}

/** Takes the formula [definition] away, also from the graphs. */
internal fun removeFormula(viewer: Viewer, definition: String) {
    viewer.formulas = viewer.formulas - definition
    nameIn(definition)?.let { viewer.graphs = viewer.graphs.withoutSignal(it) }
}

/** Has [definitions] from now on, in the open recording at once. */
internal fun takeFormulas(viewer: Viewer, definitions: List<String>) {
    viewer.formulas = definitions
    val open = viewer.open ?: return
    if (open.definitions == definitions) return
    val changed = open.withFormulas(definitions)
    viewer.open = changed
    viewer.comparisonLoading.share(changed)
}

/**
 * The sheet in which a person writes a formula.
 *
 * @property before the definition that is changed; null for a new one.
 * @property start the text it begins with.
 */
internal data class FormulaSheet(val before: String? = null, val start: String = before.orEmpty())

/** Opens the sheet for a formula, with [names] of the open recording in it; nothing happens without a recording. */
internal fun writeFormula(viewer: Viewer, names: List<String> = emptyList()) {
    val open = viewer.open ?: return
    val vocabulary = vocabularyFor(open, definition = null)
    val start = if (names.isEmpty()) "" else " = " + names.joinToString(" * ") { nameInExpression(it, vocabulary) }
    viewer.formulaSheet = FormulaSheet(start = start)
}
