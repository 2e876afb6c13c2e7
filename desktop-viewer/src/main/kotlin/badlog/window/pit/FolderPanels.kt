package badlog.window.pit

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import badlog.viewer.panel.folder.pitPanel
import badlog.viewer.panel.folder.pitTodo
import badlog.viewer.panel.folder.recordedBatteriesPanel
import badlog.viewer.panel.folder.todoPanel
import badlog.viewer.shown.folder.PitLogs
import badlog.viewer.shown.folder.pitEmptiness
import badlog.viewer.state.Action
import badlog.viewer.state.FolderRequest
import badlog.window.battery.FolderSeason
import badlog.window.folder.FolderPane
import badlog.window.folder.Library
import badlog.window.folder.LibraryActions
import badlog.window.log.AxisView
import badlog.window.todo.FolderTodo

/** The pit view, see [pitPanel]. The letters can be read from two meters away. */
@Composable
internal fun PitPane(
    library: Library,
    season: FolderSeason,
    todo: FolderTodo,
    actions: LibraryActions,
    send: (Action) -> Unit,
    modifier: Modifier = Modifier,
) {
    val state = library.state
    val batteries = season.state
    val listed = todo.listed
    LaunchedEffect(season) { season.refresh() }
    val isReading = state.folder != null && (!state.hasLooked || state.reading != null)
    val parts = remember(state.entries, isReading, batteries, listed) {
        val logs = PitLogs.of(state.ofRobots)
        pitPanel(logs, pitEmptiness(state.entries, isReading), batteries.advice, Action.Ask(FolderRequest.Batteries), pitTodo(listed))
    }
    FolderPane(parts, library, actions, send, modifier, scale = 2f)
}

/** The team's to-do list, see [todoPanel]. */
@Composable
internal fun TodoPane(todo: FolderTodo, library: Library, view: AxisView, actions: LibraryActions, modifier: Modifier = Modifier) {
    val listed = todo.listed
    val entries = library.state.entries
    val parts = remember(listed, view.unfolded, entries) {
        todoPanel(listed, view.unfolded) { name -> entries.find { it.fileName == name }?.path }
    }
    FolderPane(parts, library, actions, view::send, modifier)
}

/** The team's batteries in the folder's logs, see [recordedBatteriesPanel]. */
@Composable
internal fun BatteriesPane(season: FolderSeason, library: Library, view: AxisView, actions: LibraryActions, modifier: Modifier = Modifier) {
    val batteries = season.state
    val isReading = library.state.reading != null
    LaunchedEffect(season) { season.refresh() }
    val parts = remember(batteries, view.unfolded, isReading) {
        recordedBatteriesPanel(batteries.seasons, view.unfolded, batteries.problems, isReading)
    }
    FolderPane(parts, library, actions, view::send, modifier)
}
