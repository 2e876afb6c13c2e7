package badlog.viewer.topic

import badlog.plot.search.Query
import badlog.viewer.recording.Signal
import badlog.viewer.recording.isFoundBy

/**
 * Returns the lines that the list of topics has for [signals]: in each folder its signals in their order, then its folders
 * by name. Folders in [folded] are closed, unless there is a [query], which also finds the [empty] ones.
 *
 * @param found the names of the topics that a finding is about.
 */
internal fun topicRows(
    signals: List<Signal>,
    query: String,
    folded: Set<String>,
    empty: List<Signal> = emptyList(),
    found: Set<String> = emptySet(),
): List<TopicRow> {
    val wanted = Query(query)
    val root = TopicFolder("", "")
    for (signal in if (wanted.isEmpty) signals else signals + empty) {
        if (signal.isFoundBy(wanted, found)) root.at(signal.folder).signals += signal
    }
    val rows = ArrayList<TopicRow>()
    root.list(rows, depth = 0, folded = if (wanted.isEmpty) folded else emptySet())
    return rows
}

/** Returns the paths of all folders that [signals] are in. */
internal fun foldersOf(signals: List<Signal>): Set<String> {
    val folders = HashSet<String>()
    for (signal in signals) {
        val parts = signal.folder.split('/').filter { it.isNotEmpty() }
        parts.indices.mapTo(folders) { parts.take(it + 1).joinToString("/") }
    }
    return folders
}

/** Those of [signals] that the folder [path] lists, and the folders in it. */
internal fun topicsIn(path: String, signals: List<Signal>): List<Signal> = signals.filter { signal ->
    val folder = signal.folder.split('/').filter { it.isNotEmpty() }.joinToString("/")
    folder == path || folder.startsWith("$path/")
}

private class TopicFolder(val path: String, val title: String) {
    val signals = ArrayList<Signal>()
    private val folders = HashMap<String, TopicFolder>()

    private val count: Int get() = signals.size + folders.values.sumOf { it.count }

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
 * A line of the list of topics.
 *
 * @property depth in how many folders it lies.
 * @property key identifies it among the lines.
 */
internal sealed interface TopicRow {
    val depth: Int
    val key: String
}

/**
 * A folder.
 *
 * @property path its full name.
 * @property title its own name.
 * @property count how many signals are listed in it, and in the folders in it.
 */
internal data class FolderRow(override val depth: Int, val path: String, val title: String, val count: Int, val isOpen: Boolean) :
    TopicRow {
    override val key: String get() = "folder $path"
}

/** A signal. */
internal class SignalRow(override val depth: Int, val signal: Signal) : TopicRow {
    override val key: String get() = (if (signal.isDerived) "derived " else "signal ") + signal.name
}
