package badlog.window.topics

import androidx.compose.foundation.lazy.LazyListState
import badlog.viewer.shown.outline.MAX_OPEN_FOLDERS
import badlog.window.state.StateHolder

/**
 * The state of the list of topics. Immutable; each transition returns a new one.
 *
 * @property query words that the full name of each listed topic must contain, ignoring case.
 * @property folded the paths of the closed folders; a search opens all folders.
 * @property known the paths of all folders that were listed so far.
 * @property marked the name of the signal or path with the keyboard focus, or null.
 * @property isSearchAsked whether the search field gets the keyboard focus as soon as it is visible.
 * @property target the id of the graph to which a click adds a topic; null for a new graph.
 * @property selected the names of the selected signals, in the order of selection.
 */
internal data class TopicList(
    val query: String = "",
    val folded: Set<String> = emptySet(),
    val known: Set<String> = emptySet(),
    val selected: List<String> = emptyList(),
    val marked: String? = null,
    val isSearchAsked: Boolean = false,
    val target: Int? = null,
) {
    /** Lists a log with [folders]. If there are many, new folders are initially closed; the others stay as the user left them. */
    fun listing(folders: Set<String>): TopicList = copy(
        folded = if (folders.size > MAX_OPEN_FOLDERS) folded + (folders - known) else folded,
        known = known + folders,
        isSearchAsked = false,
        target = null,
    )

    /** From now on, a click adds a topic to graph [id] or removes it. For null, it draws the topic in its own graph again. */
    fun adding(id: Int?): TopicList = copy(target = id)

    /** Closes or opens folder [path]. */
    fun toggledFolder(path: String): TopicList = copy(folded = if (path in folded) folded - path else folded + path)

    /** Selects or deselects [name]. */
    fun toggled(name: String): TopicList = copy(selected = if (name in selected) selected - name else selected + name)

    /** Searches for [query]; no result has the keyboard focus. */
    fun searching(query: String): TopicList = copy(query = query, marked = null)

    /** Moves the keyboard focus [steps] down in [rows], or to the first row if none has it. Without rows, none has it. */
    fun marking(steps: Int, rows: List<TopicRow>): TopicList {
        val listed = rows.mapNotNull { it.name }
        val at = listed.indexOf(marked)
        return copy(marked = listed.getOrNull(if (at < 0) 0 else (at + steps).coerceIn(listed.indices)))
    }

    /** Selects all of [rows] from the last selected one to [name], in the order of the list. */
    fun selectedTo(name: String, rows: List<TopicRow>): TopicList {
        val listed = rows.filterIsInstance<SignalRow>().map { it.signal.name }
        val from = listed.indexOf(selected.lastOrNull())
        val to = listed.indexOf(name)
        if (from < 0 || to < 0) return toggled(name)
        val between = if (from <= to) listed.subList(from, to + 1) else listed.subList(to, from + 1).reversed()
        return copy(selected = (selected - between.toSet()) + between)
    }
}

/** The state of the window's list of topics. */
internal class TopicListing : StateHolder<TopicList>(TopicList()) {
    /** The scroll position of the list, kept while the list is hidden. */
    val list = LazyListState()
}
