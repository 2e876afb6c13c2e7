package badlog.viewer.library

import androidx.compose.foundation.HorizontalScrollbar
import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.focusable
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.material3.HorizontalDivider
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
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import badlog.viewer.app.Viewer
import badlog.viewer.app.openLog
import badlog.viewer.app.toggleTable
import badlog.viewer.compare.toggleCompared
import badlog.viewer.library.index.LogEntry
import badlog.viewer.panels.MainView
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton

/** Every log of the folder with all its columns. */
@Composable
internal fun LogTable(viewer: Viewer, modifier: Modifier = Modifier) {
    Column(modifier.background(LocalPalette.current.surface)) {
        TableTools(viewer)
        HorizontalDivider()
        ReadingLine(viewer)
        if (viewer.library.visible.isEmpty()) LibraryEmptiness(viewer) else Table(viewer)
    }
}

@Composable
private fun TableTools(viewer: Viewer) {
    BoxWithConstraints(Modifier.fillMaxWidth().padding(8.dp)) {
        val isNarrow = maxWidth < NARROW
        Column(verticalArrangement = Arrangement.spacedBy(6.dp)) {
            Row(horizontalArrangement = Arrangement.spacedBy(6.dp), verticalAlignment = Alignment.CenterVertically) {
                FolderMenu(viewer, if (isNarrow) Modifier.weight(1f) else Modifier.widthIn(max = 220.dp))
                if (!isNarrow) LogSearch(viewer, Modifier.weight(1f))
                LogCount(viewer)
                PreviewMenu(viewer)
                HideEmptyButton(viewer)
                ToolButton("Back to the graphs", Icons.Graph, text = if (isNarrow) null else "Graphs") { viewer.toggleTable() }
            }
            if (isNarrow) LogSearch(viewer, Modifier.fillMaxWidth())
        }
    }
}

@Composable
private fun Table(viewer: Viewer) {
    val visible = viewer.library.visible
    val topic = viewer.settings.previewTopic
    val previews = remember(visible, topic) { Previews(visible, topic) }
    val list = rememberLazyListState()
    val sideways = rememberScrollState()
    val focus = remember { FocusRequester() }
    StayAtTop(list, visible)
    KeepInSight(list, visible.indexOfFirst { it.file == viewer.library.selected })
    LaunchedEffect(Unit) { focus.requestFocus() }
    BoxWithConstraints(
        Modifier
            .fillMaxSize()
            .onKeyEvent { it.type == KeyEventType.KeyDown && onTableKey(viewer, it.key) }
            .focusRequester(focus)
            .focusable()
            .semantics { contentDescription = "Table of logs" },
    ) {
        val spare = maxOf(0.dp, maxWidth - tableWidth)
        Column(Modifier.fillMaxSize().horizontalScroll(sideways).width(tableWidth + spare)) {
            TableHead(viewer, spare)
            HorizontalDivider()
            LazyColumn(Modifier.weight(1f).padding(bottom = 8.dp), list) {
                items(visible, key = { it.file.toString() }) { entry ->
                    TableRow(
                        entry, previews, spare, viewer.library.folder,
                        isOpen = viewer.open?.file == entry.file,
                        isSelected = viewer.library.selected == entry.file,
                        isTicked = entry.file in viewer.comparison.ticked,
                        onTick = { toggleCompared(viewer, entry.file) },
                        onSelect = {
                            focus.requestFocus()
                            viewer.library = viewer.library.copy(selected = entry.file)
                        },
                        onOpen = { openFromTable(viewer, entry) },
                    )
                }
            }
        }
        VerticalScrollbar(rememberScrollbarAdapter(list), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        HorizontalScrollbar(rememberScrollbarAdapter(sideways), Modifier.align(Alignment.BottomCenter).fillMaxWidth())
    }
}

private fun onTableKey(viewer: Viewer, key: Key): Boolean {
    val library = viewer.library
    val target = when (key) {
        Key.DirectionUp -> library.stepped(-1)

        Key.DirectionDown -> library.stepped(1)

        Key.PageUp -> library.stepped(-PAGE)

        Key.PageDown -> library.stepped(PAGE)

        Key.MoveHome -> library.visible.firstOrNull()

        Key.MoveEnd -> library.visible.lastOrNull()

        Key.Enter, Key.NumPadEnter -> {
            library.visible.firstOrNull { it.file == library.selected }?.let { openFromTable(viewer, it) }
            return true
        }

        else -> return false
    }
    if (target != null) viewer.library = library.copy(selected = target.file)
    return true
}

private fun openFromTable(viewer: Viewer, entry: LogEntry) {
    viewer.openLog(entry)
    if (entry.isReadable) viewer.panels = viewer.panels.copy(main = MainView.GRAPHS)
}

private const val PAGE = 15
private val NARROW = 560.dp

private val tableWidth: Dp get() = (TICK_WIDTH + PREVIEW_WIDTH + LogColumn.entries.sumOf { it.width }).dp
