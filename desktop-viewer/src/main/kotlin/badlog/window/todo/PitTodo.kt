package badlog.window.todo

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.todo.TodoItem
import badlog.window.theme.LocalPalette

/** The open items, in letters that can be read from two meters away, and the progress of the checklist. [onOpen] shows the whole list. */
@Composable
internal fun PitTodo(todo: FolderTodo, onOpen: () -> Unit) {
    val palette = LocalPalette.current
    val open = todo.state.list.open
    val checks = todo.state.checklist
    if (todo.state.folder == null || (open.isEmpty() && checks.isEmpty())) return
    Column(
        Modifier
            .fillMaxWidth()
            .background(palette.raised, RoundedCornerShape(12.dp))
            .clickable(role = Role.Button, onClickLabel = "Show the to-do list", onClick = onOpen)
            .padding(horizontal = 24.dp, vertical = 16.dp),
        Arrangement.spacedBy(6.dp),
    ) {
        FlowRow(Modifier.fillMaxWidth(), Arrangement.SpaceBetween) {
            Line(if (open.isEmpty()) "Nothing is open" else "To do", weight = FontWeight.SemiBold)
            if (checks.isNotEmpty()) Line("Checklist: ${checks.count { it.done != null }} of ${checks.size}", palette.muted)
        }
        FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(32.dp)) {
            for (item in open.take(MAX_ITEMS)) Line("• ${textOf(item)}", if (item.isAgain) palette.error else palette.text)
            if (open.size > MAX_ITEMS) Line("and ${open.size - MAX_ITEMS} more", palette.muted)
        }
    }
}

private fun textOf(item: TodoItem): String =
    item.title + (if (item.isAgain) ", again" else "") + if (item.person.isEmpty()) "" else " (${item.person})"

@Composable
private fun Line(text: String, color: Color = LocalPalette.current.text, weight: FontWeight = FontWeight.Normal) =
    Text(text, color = color, fontSize = 28.sp, lineHeight = 36.sp, fontWeight = weight, maxLines = 1, overflow = TextOverflow.Ellipsis)

/** The number of items that are read at a glance. */
private const val MAX_ITEMS = 4
