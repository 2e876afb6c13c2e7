package badlog.viewer.library

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
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
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.app.Viewer
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.SearchField
import badlog.viewer.theme.ToolButton

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
