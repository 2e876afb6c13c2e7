package badlog.window.topics

import androidx.compose.foundation.lazy.LazyListState
import badlog.signals.pose.Pose
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.pathGraphs
import badlog.viewer.choices.board.xyGraphs
import badlog.viewer.shown.outline.MAX_OPEN_FOLDERS
import badlog.viewer.shown.search.Query
import badlog.window.log.DrawableTopic
import badlog.window.log.isFoundBy
import badlog.window.state.StateHolder

/**
 * Returns the rows of the list of topics. Each folder has its [signals] in their order, then its folders by name. Folders in [folded] are
 * closed, unless there is a [query]. A query also finds the [empty] topics.
 *
 * @param found the names of the topics that a finding is about.
 * @param poses the poses with paths that a query also finds.
 * @param offersXy whether a query also finds XY plots.
 */
internal fun topicRows(
    signals: List<DrawableTopic>,
    query: String,
    folded: Set<String>,
    empty: List<DrawableTopic> = emptyList(),
    found: Set<String> = emptySet(),
    poses: List<Pose> = emptyList(),
    offersXy: Boolean = false,
): List<TopicRow> {
    val wanted = Query(query)
    val root = TopicFolder("", "")
    for (signal in if (wanted.isEmpty) signals else signals + empty) {
        if (signal.isFoundBy(wanted, found)) root.at(signal.folder).signals += signal
    }
    val rows = ArrayList<TopicRow>()
    pathGraphs(poses, wanted).mapTo(rows, ::GraphRow)
    if (offersXy) xyGraphs(signals.filter { it.hasFigures }.map { it.name }, query).mapTo(rows, ::GraphRow)
    root.list(rows, depth = 0, folded = if (wanted.isEmpty) folded else emptySet())
    return rows
}

/** Returns the paths of all folders that contain [signals]. */
internal fun foldersOf(signals: List<DrawableTopic>): Set<String> {
    val folders = HashSet<String>()
    for (signal in signals) {
        val parts = signal.folder.split('/').filter { it.isNotEmpty() }
        parts.indices.mapTo(folders) { parts.take(it + 1).joinToString("/") }
    }
    return folders
}

/** Returns the [signals] that are in the folder [path] or in its folders. */
internal fun topicsIn(path: String, signals: List<DrawableTopic>): List<DrawableTopic> = signals.filter { signal ->
    val folder = signal.folder.split('/').filter { it.isNotEmpty() }.joinToString("/")
    folder == path || folder.startsWith("$path/")
}

private class TopicFolder(val path: String, val title: String) {
    val signals = ArrayList<DrawableTopic>()
    private val folders = HashMap<String, TopicFolder>()

    private val count: Int get() = signals.size + folders.values.sumOf { it.count }

    /** Returns the folder at [path] below this one, with slashes; creates the missing ones. */
    fun at(path: String): TopicFolder {
        var folder = this
        for (part in path.split('/')) {
            if (part.isEmpty()) continue
            val parent = folder
            folder = parent.folders.getOrPut(part) {
                TopicFolder(if (parent.path.isEmpty()) part else "${parent.path}/$part", part)
            }
        }
        return folder
    }

    /** Adds the rows of this folder to [rows]: its topics, then its folders. The content of [folded] ones, by path, is left out. */
    fun list(rows: MutableList<TopicRow>, depth: Int, folded: Set<String>) {
        signals.mapTo(rows) { SignalRow(depth, it) }
        for (folder in folders.values.sortedWith(BY_TITLE)) {
            val isOpen = folder.path !in folded
            rows += FolderRow(depth, folder.path, folder.title, folder.count, isOpen)
            if (isOpen) folder.list(rows, depth + 1, folded)
        }
    }
}

private val BY_TITLE = compareBy(String.CASE_INSENSITIVE_ORDER, TopicFolder::title).thenBy { it.title }

/**
 * A row of the list of topics.
 *
 * @property depth the number of folders around it.
 * @property key identifies it among the rows.
 * @property name the name of the topic or graph that it draws; null for a folder.
 */
internal sealed interface TopicRow {
    val depth: Int
    val key: String
    val name: String?
}

/**
 * A folder.
 *
 * @property path its full name.
 * @property title its own name.
 * @property count the number of signals listed in it and its folders.
 */
internal data class FolderRow(override val depth: Int, val path: String, val title: String, val count: Int, val isOpen: Boolean) :
    TopicRow {
    override val key: String get() = "folder $path"
    override val name: String? get() = null
}

/** A graph that a search offers beside the topics: a path on the field, or an XY plot. */
internal class GraphRow(val graph: BoardGraph) : TopicRow {
    override val depth: Int get() = 0
    override val key: String get() = "graph ${graph.title}"
    override val name: String get() = graph.title
}

/** A signal. */
internal class SignalRow(override val depth: Int, val signal: DrawableTopic) : TopicRow {
    override val key: String get() = (if (signal.isDerived) "derived " else "signal ") + signal.name
    override val name: String get() = signal.name
}

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
