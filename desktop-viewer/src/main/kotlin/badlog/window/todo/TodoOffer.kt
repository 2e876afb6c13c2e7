package badlog.window.todo

import androidx.compose.ui.graphics.vector.ImageVector
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoItem
import badlog.window.theme.Icons

/** Returns a person's possible actions on [item], which need not be on the list yet. */
internal fun todoOffers(todo: FolderTodo, item: TodoItem): List<TodoOffer> {
    val isListed = todo.state.list.item(item.task) != null
    val assign = TodoOffer("Assign…", Icons.Flag) { todo.ask(TodoSheet.Assign(item)) }
    return if (item.isOpen) {
        listOfNotNull(
            TodoOffer("Mark as done…", Icons.Check) { todo.ask(TodoSheet.Done(item)) },
            assign,
            TodoOffer("Put on the list", Icons.Add) { todo.write(item.task, TodoDeed.Open) }.takeIf { !isListed },
            TodoOffer("Take off the list", Icons.Remove) { todo.write(item.task, TodoDeed.Remove) }.takeIf { isListed },
        )
    } else {
        listOf(TodoOffer("Not done", Icons.Undo) { todo.write(item.task, TodoDeed.Open) }, assign)
    }
}

/** A possible action on an item of the list. */
internal class TodoOffer(val label: String, val icon: ImageVector, val run: () -> Unit)
