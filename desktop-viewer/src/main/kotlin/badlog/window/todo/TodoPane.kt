package badlog.window.todo

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.LazyListScope
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.catalog.folder.LogEntry
import badlog.viewer.todo.CHECKLIST_FILE
import badlog.viewer.todo.CheckedLine
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoItem
import badlog.viewer.todo.checklistTitle
import badlog.window.folder.Library
import badlog.window.folder.LibraryActions
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/** The team's to-do list: open items, the checklist before the next match, and done items, folded. [copy] copies a text. */
@Composable
internal fun TodoPane(todo: FolderTodo, library: Library, actions: LibraryActions, copy: (String) -> Unit, modifier: Modifier = Modifier) {
    val list = todo.state.list
    val hasFolder = todo.state.folder != null
    var showsDone by remember(todo.state.folder) { mutableStateOf(false) }
    val scroll = rememberLazyListState()

    fun entryOf(item: TodoItem): LogEntry? = item.found?.log?.name?.let { name -> library.state.entries.find { it.fileName == name } }
    Column(modifier.background(LocalPalette.current.surface).semantics { contentDescription = "To do" }) {
        FlowRow(Modifier.fillMaxWidth().padding(8.dp), Arrangement.spacedBy(6.dp), itemVerticalAlignment = Alignment.CenterVertically) {
            Text("To do", Modifier.weight(1f).padding(start = 8.dp), fontSize = 18.sp, fontWeight = FontWeight.SemiBold)
            ToolButton("New item", Icons.Add, text = "New item…", isEnabled = hasFolder) { todo.ask(TodoSheet.New) }
            ToolButton("Copy the list as Markdown", Icons.Copy, text = "Copy as Markdown", isEnabled = hasFolder) { copy(todo.markdown()) }
            ToolButton("Save the list as a page", Icons.Share, text = "Save as page…", isEnabled = hasFolder) { todo.savePage() }
            ToolButton("Back to the graphs", Icons.Graph, text = "Graphs") { actions.showGraphs() }
        }
        HorizontalDivider()
        Box(Modifier.weight(1f).fillMaxWidth()) {
            LazyColumn(Modifier.fillMaxSize(), scroll, PaddingValues(horizontal = 16.dp, vertical = 8.dp)) {
                if (list.open.isEmpty()) {
                    item { Hint(if (hasFolder) NOTHING_OPEN else "Open a folder of logs; its list is kept beside them.") }
                }
                items(list.open) { item -> TodoRow(todo, item, entryOf(item), actions.openFindings) }
                if (hasFolder) checklist(todo)
                if (list.done.isNotEmpty()) {
                    item { DoneHead(list.done.size, showsDone) { showsDone = !showsDone } }
                    if (showsDone) items(list.done) { item -> TodoRow(todo, item, entryOf(item), actions.openFindings) }
                }
            }
            VerticalScrollbar(rememberScrollbarAdapter(scroll), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        }
    }
}

private fun LazyListScope.checklist(todo: FolderTodo) {
    item {
        FlowRow(
            Modifier.fillMaxWidth().padding(top = 20.dp, bottom = 4.dp),
            Arrangement.spacedBy(8.dp),
            itemVerticalAlignment = Alignment.CenterVertically,
        ) {
            Text(checklistTitle(todo.state.list.next), fontSize = 15.sp, fontWeight = FontWeight.SemiBold)
            ToolButton("Set the next match", text = "Next match…") { todo.ask(TodoSheet.Next) }
        }
    }
    items(todo.state.checklist) { CheckRow(todo, it) }
    if (todo.state.files.checklist.isEmpty()) {
        item {
            Hint("To add lines of your own, write them into $CHECKLIST_FILE in the folder of the logs.")
        }
    }
}

@Composable
private fun CheckRow(todo: FolderTodo, line: CheckedLine) {
    val palette = LocalPalette.current
    val isDone = line.done != null
    val toggle = { todo.write(line.check, if (isDone) TodoDeed.Open else TodoDeed.Done()) }
    Row(
        Modifier.fillMaxWidth().clickable(onClick = toggle).padding(vertical = 2.dp),
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        TickBox("Check: ${line.check.text}", isDone, toggle)
        Text(line.check.text, Modifier.weight(1f, fill = false), color = if (isDone) palette.muted else palette.text)
        line.done?.let { Text(it.by, color = palette.muted, fontSize = 12.sp, maxLines = 1, overflow = TextOverflow.Ellipsis) }
    }
}

@Composable
private fun DoneHead(count: Int, isOpen: Boolean, onToggle: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .fillMaxWidth()
            .clickable(role = Role.Button, onClick = onToggle)
            .semantics { stateDescription = if (isOpen) "expanded" else "collapsed" }
            .padding(top = 20.dp, bottom = 4.dp),
        Arrangement.spacedBy(4.dp),
        Alignment.CenterVertically,
    ) {
        Icon(if (isOpen) Icons.Down else Icons.Right, contentDescription = null, Modifier.size(14.dp), palette.muted)
        Text("Done: $count", fontSize = 15.sp, fontWeight = FontWeight.SemiBold)
    }
}

@Composable
private fun Hint(text: String) = Text(text, Modifier.padding(vertical = 8.dp), color = LocalPalette.current.muted)

private const val NOTHING_OPEN = "Nothing is open. Errors of the last matches appear here; put others here from the findings of a log."
