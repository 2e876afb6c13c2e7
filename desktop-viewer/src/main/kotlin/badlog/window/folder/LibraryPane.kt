package badlog.window.folder

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.LinearProgressIndicator
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.LocalFocusManager
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.catalog.folder.LogEntry
import badlog.formats.READABLE_LOGS
import badlog.viewer.shown.folder.Listing
import badlog.window.panel.rows
import badlog.window.robot.RobotBar
import badlog.window.robot.RobotLink
import badlog.window.robot.RobotRecording
import badlog.window.settings.SettingsStore
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.SearchField
import badlog.window.theme.ToolButton
import badlog.window.theme.rememberAskedFocus

/** The list of logs on the left. */
@Composable
internal fun LibraryPane(
    library: Library,
    robot: RobotLink,
    recording: RobotRecording,
    settings: SettingsStore,
    shown: ShownLogs,
    actions: LibraryActions,
    modifier: Modifier = Modifier,
) {
    Column(modifier.background(LocalPalette.current.surface)) {
        LibraryHead(library, robot, settings, actions)
        RobotBar(robot, recording, settings)
        HorizontalDivider()
        ReadingLine(library)
        val visible = library.state.visible
        if (visible.isEmpty()) {
            LibraryEmptiness(library, actions)
        } else {
            LogList(library, settings, shown, actions)
        }
    }
}

@Composable
private fun LogList(library: Library, settings: SettingsStore, shown: ShownLogs, actions: LibraryActions) {
    val table = rememberTable(library, settings, shown)
    val list = rememberLazyListState()
    val selected = library.state.selectedRow
    val open = library.state.rowOf(shown.open)
    LogListPlace(list, table, selected)
    val send = sendTo(library, actions, actions.open, list)
    Box(Modifier.fillMaxSize().semantics { contentDescription = "Logs" }) {
        LazyColumn(Modifier.fillMaxSize(), list) {
            rows(table) { LogCard(it, table, isOpen = it.key == open, isSelected = it.key == selected, send) }
        }
        VerticalScrollbar(rememberScrollbarAdapter(list), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
    }
}

/** The header of the list: its folder, filters, and order. */
@Composable
internal fun LibraryHead(library: Library, robot: RobotLink, settings: SettingsStore, actions: LibraryActions) {
    Column(Modifier.padding(start = 8.dp, end = 8.dp, top = 6.dp, bottom = 2.dp)) {
        Row(verticalAlignment = Alignment.CenterVertically) {
            FolderMenu(library, settings, actions, Modifier.weight(1f))
            ToolButton("Logs from the robot", Icons.Robot, isOn = robot.state.isShown || robot.state.isOn) {
                robot.change { toggled() }
            }
            ToolButton("All logs as a table", Icons.Table) { actions.toggleTable() }
            ToolButton("Charts of these logs", Icons.Chart) { actions.toggleCharts() }
        }
        LogSearch(library, actions.open, Modifier.fillMaxWidth().padding(top = 2.dp))
        Row(verticalAlignment = Alignment.CenterVertically) {
            LogCount(library.state.listing, Modifier.weight(1f).padding(start = 4.dp))
            SortMenu(library)
            PreviewMenu(library.state.entries, settings)
            OnlyErrorsButton(library)
            HideEmptyButton(library)
        }
    }
}

/** The field that filters the logs. Enter opens the first listed one, which gets the keyboard focus; Escape lists all again. */
@Composable
internal fun LogSearch(library: Library, onOpen: (LogEntry) -> Unit, modifier: Modifier = Modifier) {
    val focus = rememberAskedFocus(library.state.isSearchAsked) { library.change { copy(isSearchAsked = false) } }
    val keyboard = LocalFocusManager.current
    val keyed = modifier
        .focusRequester(focus)
        .onPreviewKeyEvent {
            val opens = it.type == KeyEventType.KeyDown && (it.key == Key.Enter || it.key == Key.NumPadEnter)
            if (opens) {
                library.state.listing.rows.firstOrNull()?.worst?.let(onOpen)
                keyboard.clearFocus()
            }
            opens
        }
    SearchField(library.state.listing.filter, "Search logs", keyed) {
        library.change { filtered(it) }
    }
}

/** The number of listed logs. */
@Composable
internal fun LogCount(listing: Listing<LogEntry>, modifier: Modifier = Modifier) {
    Text(listing.count, modifier, color = LocalPalette.current.muted, fontSize = 12.sp, lineHeight = 16.sp, maxLines = 1)
}

/** The button that hides idle logs. */
@Composable
internal fun HideEmptyButton(library: Library) {
    val hides = library.state.listing.hidesEmpty
    ToolButton("Hide idle logs", Icons.Hide, isOn = hides) {
        library.change { hidingEmpty(!hides) }
    }
}

/** The button that lists only logs in which a rule found an error. */
@Composable
internal fun OnlyErrorsButton(library: Library) {
    val isOn = library.state.listing.onlyErrors
    ToolButton("Only logs in which rules found an error", Icons.Diamond, isOn = isOn) {
        library.change { onlyErrors(!isOn) }
    }
}

/** The explanation in place of an empty list, with a button for opening a folder or listing all logs. */
@Composable
internal fun LibraryEmptiness(library: Library, actions: LibraryActions, modifier: Modifier = Modifier) {
    Column(modifier.padding(16.dp), verticalArrangement = Arrangement.spacedBy(12.dp)) {
        Text(emptinessOf(library.state), color = LocalPalette.current.muted)
        if (library.state.listing.size == 0) {
            ToolButton("Open a folder of logs", Icons.Folder, text = "Open folder…") { actions.opener.askForFolder() }
        } else {
            ToolButton("List all logs", Icons.Reset, text = "List all logs") {
                library.change { filtered("").hidingEmpty(false).onlyErrors(false) }
            }
        }
    }
}

private fun emptinessOf(library: LibraryState): String = when {
    library.folder == null -> "Open the folder where the robot’s logs are, or drop it onto this window."

    library.listing.size > 0 -> library.listing.emptiness

    !library.hasLooked -> "Looking for logs…"

    library.reading != null -> "Reading the first logs…"

    library.trouble != null -> "No logs found."

    else ->
        "No logs here yet. Those in this folder and its subfolders are listed: $READABLE_LOGS; compressed (.gz) ones, too. New logs " +
            "appear automatically."
}

/** The progress of reading the folder, or the reason why it cannot be read; empty if everything is known. */
@Composable
internal fun ReadingLine(library: Library) {
    val state = library.state
    val palette = LocalPalette.current
    Column(Modifier.fillMaxWidth()) {
        state.trouble?.let { trouble ->
            Text(
                trouble,
                Modifier.fillMaxWidth().background(palette.warningSoft).padding(horizontal = 12.dp, vertical = 6.dp),
                color = palette.warning,
                fontSize = 12.sp,
                lineHeight = 16.sp,
                maxLines = 4,
                overflow = TextOverflow.Ellipsis,
            )
        }
        val reading = state.reading
        // A growing log is read repeatedly, so its progress is not shown.
        if (reading != null && reading.total > 1) {
            NoteLine("Reading ${reading.read} of ${reading.total} logs", "Stop", "Stop reading logs") {
                library.stopReading()
            }
            LinearProgressIndicator(
                progress = { reading.read.toFloat() / reading.total },
                modifier = Modifier.fillMaxWidth().height(2.dp),
                gapSize = 0.dp,
                drawStopIndicator = {},
            )
        } else if (state.passedOver > 0) {
            val logs = if (state.passedOver == 1) "1 log is" else "${state.passedOver} logs are"
            NoteLine("$logs not read", "Read", "Read the other logs") { library.readAll() }
        }
    }
}

@Composable
private fun NoteLine(text: String, action: String, description: String, onAction: () -> Unit) {
    Row(Modifier.padding(start = 12.dp, end = 4.dp), verticalAlignment = Alignment.CenterVertically) {
        val muted = LocalPalette.current.muted
        Text(text, Modifier.weight(1f), color = muted, fontSize = 12.sp, maxLines = 1, overflow = TextOverflow.Ellipsis)
        ToolButton(description, text = action, onClick = onAction)
    }
}
