package badlog.window.folder

import androidx.compose.foundation.HorizontalScrollbar
import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.focusable
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
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
import badlog.catalog.folder.LogEntry
import badlog.viewer.shown.folder.LogColumn
import badlog.window.settings.SettingsStore
import badlog.window.theme.KeepInSight
import badlog.window.theme.LocalPalette
import badlog.window.theme.StayAtTop

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
    val visible = library.state.visible
    val topic = settings.state.previewTopic
    val previews = remember(visible, topic) { Previews(visible, topic) }
    val list = rememberLazyListState()
    val sideways = rememberScrollState()
    val focus = remember { FocusRequester() }
    StayAtTop(list, visible)
    KeepInSight(list, visible.indexOfFirst { it.file == library.state.selected })
    LaunchedEffect(Unit) { focus.requestFocus() }
    BoxWithConstraints(
        Modifier
            .fillMaxSize()
            .onKeyEvent { it.type == KeyEventType.KeyDown && onTableKey(library, it.key, actions.openInGraphs) }
            .focusRequester(focus)
            .focusable()
            .semantics { contentDescription = "Table of logs" },
    ) {
        val spare = maxOf(0.dp, maxWidth - tableWidth)
        Column(Modifier.fillMaxSize().horizontalScroll(sideways).width(tableWidth + spare)) {
            TableHead(library, settings.state.previewTopic, spare)
            HorizontalDivider()
            LazyColumn(Modifier.weight(1f).padding(bottom = 8.dp), list) {
                items(visible, key = { it.file.toString() }) { entry ->
                    TableRow(
                        entry, previews, spare, library.state.folder,
                        isOpen = shown.open == entry.file,
                        isSelected = library.state.selected == entry.file,
                        isChecked = entry.file in shown.checked,
                        onCheck = { actions.check(entry.file) },
                        onSelect = {
                            focus.requestFocus()
                            library.select(entry.file)
                        },
                        onOpen = { actions.openInGraphs(entry) },
                        onFindings = { actions.openFindings(entry) },
                    )
                }
            }
        }
        VerticalScrollbar(rememberScrollbarAdapter(list), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        HorizontalScrollbar(rememberScrollbarAdapter(sideways), Modifier.align(Alignment.BottomCenter).fillMaxWidth())
    }
}

private fun onTableKey(library: Library, key: Key, onOpen: (LogEntry) -> Unit): Boolean {
    val state = library.state
    val target = when (key) {
        Key.DirectionUp -> state.stepped(-1)

        Key.DirectionDown -> state.stepped(1)

        Key.PageUp -> state.stepped(-PAGE)

        Key.PageDown -> state.stepped(PAGE)

        Key.MoveHome -> state.visible.firstOrNull()

        Key.MoveEnd -> state.visible.lastOrNull()

        Key.Enter, Key.NumPadEnter -> {
            state.visible.firstOrNull { it.file == state.selected }?.let(onOpen)
            return true
        }

        else -> return false
    }
    if (target != null) library.select(target.file)
    return true
}

private const val PAGE = 15

private val tableWidth: Dp get() = (CHECK_WIDTH + PREVIEW_WIDTH + LogColumn.entries.sumOf { it.width }).dp
