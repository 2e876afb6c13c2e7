package badlog.cli.todo

import badlog.catalog.todo.newChange
import badlog.cli.input.Failure
import badlog.cli.text.counted
import badlog.viewer.todo.TodoChange
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoItem
import badlog.viewer.todo.TodoList
import badlog.viewer.todo.TodoLog
import badlog.viewer.todo.matchText

/** The items of this list, in the order in which they are printed; the first is number 1. */
internal val TodoList.numbered: List<TodoItem> get() = open + done

/**
 * A change of the list by a person.
 *
 * @param number the number of the item.
 * @param isDone whether it is done now; otherwise it is to be done again.
 * @param what the work that was done; may be empty.
 * @param author the name of the person.
 */
internal class TodoMark(private val number: Int, private val isDone: Boolean, private val what: String, private val author: String) {
    /**
     * Returns the change of [list], which was made from [known] changes and [logs]. Null if the item already has that state, and there is
     * no new text.
     *
     * @throws Failure if there is no such item.
     */
    fun changeOf(list: TodoList, logs: List<TodoLog>, known: List<TodoChange>): TodoChange? {
        val items = list.numbered
        val item = items.getOrNull(number - 1)
            ?: throw Failure("The list has ${counted(items.size.toLong(), "item")}, but no number $number; badlog todo prints the numbers.")
        if (item.isOpen != isDone && what.isEmpty()) return null
        val deed = if (isDone) TodoDeed.Done(what, if (item.isOpen) nextIn(list) else item.done?.before) else TodoDeed.Open
        return newChange(item.task, deed, author, logs.filter { it.isDated }.maxByOrNull { it.second }, known)
    }

    private fun nextIn(list: TodoList) = matchText(list.next, list.lastMatch).ifEmpty { null }

    /** Returns the sentence about the item of [list] after [change]; null if there was nothing to change. */
    fun sentenceFor(list: TodoList, change: TodoChange?): String {
        val title = "“${list.numbered[number - 1].title}”"
        return when {
            change != null -> "$title is ${if (isDone) "done" else "to be done"} now."
            isDone -> "$title was done already; nothing was written. Describe the work with --what."
            else -> "$title is already open; nothing was written."
        }
    }
}
