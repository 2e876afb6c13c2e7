package badlog.viewer.library

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
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.LinearProgressIndicator
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
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
import badlog.viewer.app.Viewer
import badlog.viewer.app.chooseFolder
import badlog.viewer.app.openLog
import badlog.viewer.app.toggleTable
import badlog.viewer.compare.toggleCompared
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.SearchField
import badlog.viewer.theme.ToolButton

/** The list of logs at the left. */
@Composable
internal fun LibraryPane(viewer: Viewer, modifier: Modifier = Modifier) {
    Column(modifier.background(LocalPalette.current.surface)) {
        LibraryHead(viewer)
        HorizontalDivider()
        ReadingLine(viewer)
        val visible = viewer.library.visible
        if (visible.isEmpty()) {
            LibraryEmptiness(viewer)
        } else {
            LogList(viewer)
        }
    }
}

@Composable
private fun LogList(viewer: Viewer) {
    val visible = viewer.library.visible
    val topic = viewer.settings.previewTopic
    val previews = remember(visible, topic) { Previews(visible, topic) }
    val list = rememberLazyListState()
    StayAtTop(list, visible)
    KeepInSight(list, visible.indexOfFirst { it.file == viewer.library.selected })
    Box(Modifier.fillMaxSize().semantics { contentDescription = "Logs" }) {
        LazyColumn(Modifier.fillMaxSize(), list) {
            items(visible, key = { it.file.toString() }) { entry ->
                LogRow(
                    entry = entry,
                    previews = previews,
                    isOpen = viewer.open?.file == entry.file,
                    isSelected = viewer.library.selected == entry.file,
                    isTicked = entry.file in viewer.comparison.ticked,
                    onOpen = { viewer.openLog(entry) },
                    onTick = { toggleCompared(viewer, entry.file) },
                )
            }
        }
        VerticalScrollbar(rememberScrollbarAdapter(list), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
    }
}

/** What stands above the list: which folder it is of, and what of it is listed how. */
@Composable
internal fun LibraryHead(viewer: Viewer) {
    Column(Modifier.padding(start = 8.dp, end = 8.dp, top = 6.dp, bottom = 2.dp)) {
        Row(verticalAlignment = Alignment.CenterVertically) {
            FolderMenu(viewer, Modifier.weight(1f))
            ToolButton("All logs as a table", Icons.Table) { viewer.toggleTable() }
        }
        LogSearch(viewer, Modifier.fillMaxWidth().padding(top = 2.dp))
        Row(verticalAlignment = Alignment.CenterVertically) {
            LogCount(viewer, Modifier.weight(1f).padding(start = 4.dp))
            SortMenu(viewer)
            PreviewMenu(viewer)
            HideEmptyButton(viewer)
        }
    }
}

/** The field that filters the logs; Enter opens the first that is left and gives the keyboard back, Escape lists all again. */
@Composable
internal fun LogSearch(viewer: Viewer, modifier: Modifier = Modifier) {
    val focus = remember { FocusRequester() }
    val keyboard = LocalFocusManager.current
    val asked = viewer.library.searchesAsked
    val before = remember { intArrayOf(asked) }
    LaunchedEffect(asked) {
        // What was asked before this field was there was meant for another one.
        if (asked != before[0]) focus.requestFocus()
        before[0] = asked
    }
    val keyed = modifier
        .focusRequester(focus)
        .onPreviewKeyEvent {
            val opens = it.type == KeyEventType.KeyDown && (it.key == Key.Enter || it.key == Key.NumPadEnter)
            if (opens) {
                viewer.library.visible.firstOrNull()?.let(viewer::openLog)
                keyboard.clearFocus()
            }
            opens
        }
    SearchField(viewer.library.listing.filter, "Search logs", keyed) {
        viewer.library = viewer.library.filtered(it)
    }
}

/** How many logs are listed. */
@Composable
internal fun LogCount(viewer: Viewer, modifier: Modifier = Modifier) {
    val listing = viewer.library.listing
    val all = when (listing.size) {
        0 -> "No logs"
        1 -> "1 log"
        else -> "${listing.size} logs"
    }
    val text = if (listing.visible.size == listing.size) all else "${listing.visible.size} of $all"
    Text(text, modifier, color = LocalPalette.current.muted, fontSize = 12.sp, lineHeight = 16.sp, maxLines = 1)
}

/** Leaves out logs in which nothing happened. */
@Composable
internal fun HideEmptyButton(viewer: Viewer) {
    val hides = viewer.library.listing.hidesEmpty
    ToolButton("Hide logs where nothing happened", Icons.Hide, isOn = hides) {
        viewer.library = viewer.library.hidingEmpty(!hides)
    }
}

/** What stands where logs would be listed if there were any. */
@Composable
internal fun LibraryEmptiness(viewer: Viewer, modifier: Modifier = Modifier) {
    Column(modifier.padding(16.dp), verticalArrangement = Arrangement.spacedBy(12.dp)) {
        Text(emptinessOf(viewer.library), color = LocalPalette.current.muted)
        if (viewer.library.listing.size == 0) {
            ToolButton("Open a folder of logs", Icons.Folder, text = "Open folder…") { chooseFolder(viewer) }
        } else {
            ToolButton("List all logs", Icons.Reset, text = "List all logs") {
                viewer.library = viewer.library.filtered("").hidingEmpty(false)
            }
        }
    }
}

private fun emptinessOf(library: LibraryState): String = when {
    library.folder == null -> "Open the folder where the robot’s logs are, or drop it onto this window."

    library.listing.size > 0 && library.listing.filter.isNotBlank() -> "No log has all of “${library.listing.filter.trim()}”."

    library.listing.size > 0 -> "Nothing happened in any of these logs."

    !library.hasLooked -> "Looking for logs…"

    library.reading != null -> "Reading the first logs…"

    library.trouble != null -> "No log is to be seen here."

    else ->
        "No logs here yet. Bags (.bag, .badbag), tables (.csv) and logs of WPILib (.wpilog) of this folder and the folders in it " +
            "are listed, also when they are compressed (.gz). A new one appears by itself."
}

/** How far reading the folder is, and what hinders it; nothing when all is known. */
@Composable
internal fun ReadingLine(viewer: Viewer) {
    val library = viewer.library
    val palette = LocalPalette.current
    Column(Modifier.fillMaxWidth()) {
        library.trouble?.let { trouble ->
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
        val reading = library.reading
        // One log that grows is read again and again: nothing that a person waits for.
        if (reading != null && reading.total > 1) {
            NoteLine("Reading ${reading.read} of ${reading.total} logs", "Stop", "Stop reading logs") {
                viewer.libraryFolder.stopReading()
            }
            LinearProgressIndicator(
                progress = { reading.read.toFloat() / reading.total },
                modifier = Modifier.fillMaxWidth().height(2.dp),
                gapSize = 0.dp,
                drawStopIndicator = {},
            )
        } else if (library.passedOver > 0) {
            val logs = if (library.passedOver == 1) "1 log is" else "${library.passedOver} logs are"
            NoteLine("$logs not read", "Read", "Read the other logs") { viewer.libraryFolder.readAll() }
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
