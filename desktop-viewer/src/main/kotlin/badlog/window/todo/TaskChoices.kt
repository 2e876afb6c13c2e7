package badlog.window.todo

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.vector.ImageVector
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoItem
import badlog.viewer.todo.TodoTask
import badlog.viewer.todo.againText
import badlog.viewer.todo.text
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/** The state of [task] on the list, below its finding or note; empty if it is not on the list. */
@Composable
internal fun TodoMark(todo: FolderTodo, task: TodoTask) {
    val palette = LocalPalette.current
    val item = todo.state.list.item(task) ?: return
    val done = item.done
    if (item.isAgain) Text(item.againText, color = palette.error, fontSize = 12.sp)
    if (done != null && (!item.isOpen || item.isAgain)) {
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(4.dp)) {
            if (!item.isOpen) Icon(Icons.Check, contentDescription = "done", Modifier.padding(top = 2.dp).size(14.dp), palette.accent)
            Text(done.text, color = palette.muted, fontSize = 12.sp)
        }
    }
    if (item.isOpen && item.person.isNotEmpty()) Text("To do: ${item.person}", color = palette.muted, fontSize = 12.sp)
}

/** The buttons for the actions on [task]. */
@Composable
internal fun TodoButtons(todo: FolderTodo, task: TodoTask) {
    if (todo.state.folder == null) return
    val item = todo.state.list.itemOrNew(task)
    FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(2.dp)) {
        for (offer in todoOffers(todo, item)) {
            ToolButton("${offer.label}: ${item.title}", offer.icon, text = offer.label, onClick = offer.run)
        }
    }
}

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
