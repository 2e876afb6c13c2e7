package badlog.window.todo

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.selection.toggleable
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.catalog.folder.LogEntry
import badlog.viewer.panel.offersFor
import badlog.viewer.text.word
import badlog.viewer.todo.TodoItem
import badlog.viewer.todo.lines
import badlog.window.findings.findingColor
import badlog.window.panel.vector
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/** An [item] of the list with its actions; [onOpen] opens [log], in which it was found last. */
@Composable
internal fun TodoRow(todo: FolderTodo, item: TodoItem, log: LogEntry?, onOpen: (LogEntry) -> Unit) {
    val palette = LocalPalette.current
    val severity = item.found?.severity?.takeIf { item.isOpen }
    val offers = todo.state.list.offersFor(item.task)
    Row(Modifier.fillMaxWidth().padding(vertical = 6.dp), Arrangement.spacedBy(8.dp)) {
        TickBox("${offers.first().label.trimEnd('…')}: ${item.title}", !item.isOpen) { todo.perform(offers.first().request) }
        Column(Modifier.weight(1f)) {
            FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp), itemVerticalAlignment = Alignment.CenterVertically) {
                Text(item.title, color = severity?.let(palette::findingColor) ?: palette.text, fontWeight = FontWeight.Medium)
                if (severity != null) Text(severity.word, color = palette.muted, fontSize = 12.sp)
                if (item.person.isNotEmpty()) {
                    Text(
                        item.person,
                        Modifier.background(palette.accentSoft, RoundedCornerShape(4.dp)).padding(horizontal = 6.dp),
                        fontSize = 12.sp,
                    )
                }
            }
            item.lines.forEachIndexed { i, line ->
                Text(line, color = if (i == 0 && item.isAgain) palette.error else palette.muted, fontSize = 12.sp)
            }
        }
        Row(Modifier, Arrangement.spacedBy(2.dp)) {
            if (log != null) ToolButton("Show what was found in ${log.title}", Icons.Graph) { onOpen(log) }
            // The box already is the first of them.
            for (offer in offers.drop(1)) {
                ToolButton("${offer.label}: ${item.title}", offer.icon.vector, offer.label.takeIf { it.endsWith('…') }) {
                    todo.perform(offer.request)
                }
            }
        }
    }
}

/** A box that is ticked or not, called [name]. */
@Composable
internal fun TickBox(name: String, isTicked: Boolean, onToggle: () -> Unit) {
    val palette = LocalPalette.current
    val shape = RoundedCornerShape(4.dp)
    Box(
        Modifier
            .clip(shape)
            .toggleable(isTicked, role = Role.Checkbox) { onToggle() }
            .semantics { contentDescription = name }
            .padding(2.dp)
            .size(18.dp)
            .background(if (isTicked) palette.accentSoft else palette.raised, shape)
            .border(1.5.dp, if (isTicked) palette.accent else palette.muted, shape),
        Alignment.Center,
    ) { if (isTicked) Icon(Icons.Check, contentDescription = null, Modifier.size(14.dp), palette.accent) }
}
