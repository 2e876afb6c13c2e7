package badlog.window.topics

import badlog.signals.pose.Pose
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.pathGraphs
import badlog.viewer.choices.board.xyGraphs
import badlog.viewer.shown.search.Query
import badlog.window.log.DrawableTopic
import badlog.window.log.isFoundBy

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
