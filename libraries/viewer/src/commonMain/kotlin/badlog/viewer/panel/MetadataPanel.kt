package badlog.viewer.panel

import badlog.core.analysis.Folder
import badlog.core.recording.PathName
import badlog.viewer.shown.search.Query
import badlog.viewer.state.Action
import badlog.viewer.state.Request
import badlog.core.recording.Value as KnownValue

/**
 * Returns the values that were known when a recording began, for a panel of their own: those that [search] finds, by folder.
 *
 * @param unfolded the folders that a person has folded or unfolded, see [ViewerState][badlog.viewer.state.ViewerState].
 */
fun metadataPanel(folders: List<Folder>, search: String, unfolded: Map<String, Boolean>): List<Part> {
    if (folders.all { it.values.isEmpty() }) return listOf(hint("This log has no metadata: its header is empty."))
    val query = Query(search)
    val found = folders.map { it.name to valueRows(it.values, query, ::copying) }.filter { (_, values) -> values.rows.isNotEmpty() }
    if (found.isEmpty()) return listOf(hint("Nothing matches “$search”."))
    return found.map { (folder, values) ->
        val key = "value-folder $folder"
        if (folder.isEmpty()) values else Fold(key, folder, search.isNotEmpty() || unfolded[key] ?: true, listOf(values))
    }
}

/** Returns the [values] of a folder that [query] matches, each with the buttons that [tools] returns. */
fun valueRows(values: List<KnownValue>, query: Query, tools: (KnownValue) -> List<Button> = { emptyList() }): Rows {
    val found = values.filter { query.matches("${it.name} ${it.text}") }
    return Rows(
        "values",
        "Values",
        found.mapIndexed { i, value ->
            Value("value-row $i", PathName.baseNameOf(value.name), value.text.ifEmpty { "empty" }, tools = tools(value), maxLines = 12)
        },
    )
}

private fun copying(value: KnownValue) = listOf(Button("Copy ${value.name}", Action.Ask(Request.Copy { value.text }), PartIcon.COPY))

private fun hint(text: String) = Paragraph("none", text, Tone.MUTED)
