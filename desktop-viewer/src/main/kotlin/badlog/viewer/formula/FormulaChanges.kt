package badlog.viewer.formula

import badlog.expression.LogViewSignals
import badlog.expression.Vocabulary
import badlog.viewer.app.Viewer
import badlog.viewer.recording.OpenRecording

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
