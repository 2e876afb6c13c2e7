package badlog.viewer.topic

import badlog.plot.outline.MANY_FOLDERS
import badlog.viewer.part.Part

/**
 * How the list of topics is shown. Never changes; each transition gives a new one.
 *
 * @property query words that must be in the full name of what is listed, regardless of case.
 * @property folded the paths of the folders that are closed; a search opens them all.
 * @property known the paths of all folders that were listed so far.
 * @property marked the name of the signal on which the keyboard stands, or null.
 * @property searchesAsked how often the keyboard asked for the search field.
 * @property target the graph to which a click adds a topic, by its id; null for a graph of its own.
 * @property selected the names of the signals that are selected, in the order in which they were.
 */
internal data class TopicList(
    val query: String = "",
    val folded: Set<String> = emptySet(),
    val known: Set<String> = emptySet(),
    val selected: List<String> = emptyList(),
    val marked: String? = null,
    val searchesAsked: Int = 0,
    val target: Int? = null,
) {
    /** Lists a log with [folders]. Where they are many, those that are new begin closed; the others stay as a person left them. */
    fun listing(folders: Set<String>): TopicList =
        copy(folded = if (folders.size > MANY_FOLDERS) folded + (folders - known) else folded, known = known + folders, target = null)

    /** Returns a click adds a topic to graph [id], or takes it out; for null it draws it in a graph of its own again. */
    fun adding(id: Int?): TopicList = copy(target = id)

    /** Closes folder [path], or opens it. */
    fun toggledFolder(path: String): TopicList = copy(folded = if (path in folded) folded - path else folded + path)

    /** Selects [name], or no longer. */
    fun toggled(name: String): TopicList = copy(selected = if (name in selected) selected - name else selected + name)

    /** Searches for [query]; the keyboard stands nowhere in what is found. */
    fun searching(query: String): TopicList = copy(query = query, marked = null)

    /** The keyboard stands [steps] further down [rows], or on the first; on none where there are none. */
    fun marking(steps: Int, rows: List<TopicRow>): TopicList {
        val listed = rows.filterIsInstance<SignalRow>().map { it.signal.name }
        val at = listed.indexOf(marked)
        return copy(marked = listed.getOrNull(if (at < 0) 0 else (at + steps).coerceIn(listed.indices)))
    }

    /** Selects all of [rows] from the one selected last to [name], in the order in which they are listed. */
    fun selectedTo(name: String, rows: List<TopicRow>): TopicList {
        val listed = rows.filterIsInstance<SignalRow>().map { it.signal.name }
        val from = listed.indexOf(selected.lastOrNull())
        val to = listed.indexOf(name)
        if (from < 0 || to < 0) return toggled(name)
        val between = if (from <= to) listed.subList(from, to + 1) else listed.subList(to, from + 1).reversed()
        return copy(selected = (selected - between.toSet()) + between)
    }
}

/** How the window's list of topics is shown. */
internal class TopicListing : Part<TopicList>(TopicList())
