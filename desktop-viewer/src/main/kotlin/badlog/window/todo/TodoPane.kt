package badlog.window.todo

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import badlog.viewer.panel.folder.todoPanel
import badlog.viewer.state.Action
import badlog.viewer.state.FolderRequest
import badlog.window.folder.FolderPane
import badlog.window.folder.Library
import badlog.window.folder.LibraryActions
import badlog.window.log.AxisView

/** The team's to-do list, see [todoPanel]. [copy] copies a text. */
@Composable
internal fun TodoPane(
    todo: FolderTodo,
    library: Library,
    view: AxisView,
    actions: LibraryActions,
    copy: (String) -> Unit,
    modifier: Modifier = Modifier,
) {
    val listed = todo.listed
    val entries = library.state.entries
    val parts = remember(listed, view.unfolded, entries) {
        todoPanel(listed, view.unfolded) { name -> entries.find { it.fileName == name }?.path }
    }
    val send = { action: Action ->
        if ((action as? Action.Ask)?.request == FolderRequest.CopyTodo) copy(todo.markdown()) else view.send(action)
    }
    FolderPane(parts, library, actions, send, modifier)
}
