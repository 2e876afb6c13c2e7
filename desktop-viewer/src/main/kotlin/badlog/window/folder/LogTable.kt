package badlog.window.folder

import androidx.compose.foundation.background
import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.material3.HorizontalDivider
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import badlog.catalog.folder.LogEntry
import badlog.viewer.panel.Table
import badlog.viewer.panel.folder.logTable
import badlog.viewer.panel.folder.withPreviews
import badlog.viewer.state.Action
import badlog.viewer.state.FolderAction
import badlog.window.panel.WideTableView
import badlog.window.settings.SettingsStore
import badlog.window.theme.KeepInSight
import badlog.window.theme.LocalPalette
import badlog.window.theme.StayAtTop
import java.nio.file.Path

/** Every log of the folder with all its columns. */
@Composable
internal fun LogTable(library: Library, settings: SettingsStore, shown: ShownLogs, actions: LibraryActions, modifier: Modifier = Modifier) {
    Column(modifier.background(LocalPalette.current.surface)) {
        FolderTools(library, settings, actions) { PreviewMenu(library.state.entries, settings) }
        HorizontalDivider()
        ReadingLine(library)
        if (library.state.visible.isEmpty()) LibraryEmptiness(library, actions) else Table(library, settings, shown, actions)
    }
}

@Composable
private fun Table(library: Library, settings: SettingsStore, shown: ShownLogs, actions: LibraryActions) {
    val table = rememberTable(library, settings, shown)
    val list = rememberLazyListState()
    val focus = remember { FocusRequester() }
    val selected = library.state.selectedRow
    LogListPlace(list, table, selected)
    LaunchedEffect(Unit) { focus.requestFocus() }
    Box(
        Modifier
            .fillMaxSize()
            .onKeyEvent { it.type == KeyEventType.KeyDown && onTableKey(library, it.key, actions) }
            .focusRequester(focus)
            .focusable()
            .semantics { contentDescription = "Table of logs" },
    ) {
        WideTableView(
            table,
            sendTo(library, actions, list = list),
            list,
            selected,
            library.state.rowOf(shown.open),
        ) { row ->
            focus.requestFocus()
            library.select(Path.of(row.key))
        }
    }
}

/** Returns the listed logs as a table, see [logTable]. */
@Composable
internal fun rememberTable(library: Library, settings: SettingsStore, shown: ShownLogs): Table {
    val listing = library.state.listing
    val topic = settings.state.previewTopic
    return remember(listing, topic, shown.checked) {
        logTable(listing, shown.checked.mapTo(HashSet()) { "$it" }).withPreviews(listing.visible, topic)
    }
}

/** Keeps the selected row of [table] in sight, and [list] at its top when logs are added above. */
@Composable
internal fun LogListPlace(list: LazyListState, table: Table, selected: String?) {
    StayAtTop(list, table.groups)
    val keys =
        remember(table) { table.groups.flatMap { group -> listOf("").filter { group.title.isNotEmpty() } + group.rows.map { it.key } } }
    KeepInSight(list, selected, keys.indexOf(selected))
}

/** Returns the function that performs actions on the listed logs, and [others]; [open] opens one. After sorting, [list] is at its top. */
internal fun sendTo(
    library: Library,
    actions: LibraryActions,
    open: (LogEntry) -> Unit = actions.openInGraphs,
    list: LazyListState? = null,
    others: (Action) -> Unit = {},
): (Action) -> Unit = { action ->
    when (action) {
        is FolderAction.Sort -> {
            library.change { sorted(action.column) }
            list?.requestScrollToItem(0)
        }

        is FolderAction.Check -> actions.check(Path.of(action.path))

        is FolderAction.Open -> library.state.entries.find {
            it.path == action.path
        }?.let(if (action.showsFinding) actions.openFindings else open)

        else -> others(action)
    }
}

private fun onTableKey(library: Library, key: Key, actions: LibraryActions): Boolean {
    val state = library.state
    val target = when (key) {
        Key.DirectionUp -> state.stepped(-1)

        Key.DirectionDown -> state.stepped(1)

        Key.PageUp -> state.stepped(-PAGE)

        Key.PageDown -> state.stepped(PAGE)

        Key.MoveHome -> state.listing.rows.firstOrNull()?.worst

        Key.MoveEnd -> state.listing.rows.lastOrNull()?.worst

        Key.Enter, Key.NumPadEnter -> {
            state.visible.find { it.file == state.selected }?.let(actions.openInGraphs)
            return true
        }

        Key.Spacebar -> {
            state.visible.find { it.file == state.selected && it.isReadable }?.let { actions.check(it.file) }
            return true
        }

        else -> return false
    }
    if (target != null) library.select(target.file)
    return true
}

private const val PAGE = 15
