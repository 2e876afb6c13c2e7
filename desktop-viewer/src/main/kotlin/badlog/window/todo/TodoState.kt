package badlog.window.todo

import badlog.catalog.todo.TodoFiles
import badlog.catalog.todo.TodoFolder
import badlog.viewer.todo.CheckedLine
import badlog.viewer.todo.TodoChange
import badlog.viewer.todo.TodoList
import badlog.viewer.todo.TodoLog

/**
 * The to-do list of the open folder, as the window knows it.
 *
 * @property folder the folder that stores it; null while no folder is open.
 * @property files the content that was read last.
 * @property written the changes by this window since then.
 * @property logs the logs of the folder, with their findings.
 * @property ofRules the lines of the checklist that come from the folder's rules.
 */
internal data class TodoState(
    val folder: TodoFolder? = null,
    val files: TodoFiles = TodoFiles(),
    val written: List<TodoChange> = emptyList(),
    val logs: List<TodoLog> = emptyList(),
    val ofRules: List<String> = emptyList(),
) {
    /** The list. */
    val list: TodoList by lazy { TodoList.of(files.changes + written, logs) }

    /** The lines of the checklist: the lines of the rules, then the team's own. */
    val lines: List<String> get() = (ofRules + files.checklist).distinct()

    /** The checklist before the next match. */
    val checklist: List<CheckedLine> by lazy { list.checklist(lines) }

    /** Returns the state with the [read] content, and without the written changes that it contains. */
    fun reading(read: TodoFiles, ofRules: List<String>): TodoState {
        val ids = read.changes.mapTo(HashSet()) { it.id }
        return copy(files = read, ofRules = ofRules, written = written.filter { it.id !in ids })
    }
}
