package badlog.viewer.topic

import badlog.viewer.recording.Signal

/**
 * A line of the list of topics.
 *
 * @property depth in how many folders it lies.
 * @property key tells it from the other lines.
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
