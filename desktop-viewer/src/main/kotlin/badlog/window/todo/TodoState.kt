package badlog.window.todo

import badlog.catalog.todo.TodoFiles
import badlog.catalog.todo.TodoFolder
import badlog.viewer.todo.CheckedLine
import badlog.viewer.todo.FoundLog
import badlog.viewer.todo.TodoChange
import badlog.viewer.todo.TodoItem
import badlog.viewer.todo.TodoList

/**
 * What the team of the open folder has to do, as the window knows it.
 *
 * @property folder where it is kept; null while no folder is open.
 * @property files what was read there.
 * @property written what this window has changed since.
 * @property logs what the rules found in the logs of the folder.
 * @property ofRules the lines of the checklist that the folder's rules have.
 * @property sheet the dialog that is open; null for none.
 */
internal data class TodoState(
    val folder: TodoFolder? = null,
    val files: TodoFiles = TodoFiles(),
    val written: List<TodoChange> = emptyList(),
    val logs: List<FoundLog> = emptyList(),
    val ofRules: List<String> = emptyList(),
    val sheet: TodoSheet? = null,
) {
    /** The list. */
    val list: TodoList by lazy { TodoList.of(files.changes + written, logs) }

    /** The lines of the checklist: those of the rules, then the team's own. */
    val lines: List<String> get() = (ofRules + files.checklist).distinct()

    /** The checklist before the next match. */
    val checklist: List<CheckedLine> by lazy { list.checklist(lines) }

    /** Returns the same with what was [read], and without what is among it. */
    fun reading(read: TodoFiles, ofRules: List<String>): TodoState {
        val ids = read.changes.mapTo(HashSet()) { it.id }
        return copy(files = read, ofRules = ofRules, written = written.filter { it.id !in ids })
    }
}

/** A dialog about the list. */
internal sealed interface TodoSheet {
    /** Asks how [item] was done. */
    data class Done(val item: TodoItem) : TodoSheet

    /** Asks who takes [item] on. */
    data class Assign(val item: TodoItem) : TodoSheet

    /** Asks what else is to be done. */
    data object New : TodoSheet

    /** Asks which match is the next one. */
    data object Next : TodoSheet
}
