package badlog.viewer.library

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.material3.HorizontalDivider
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import badlog.viewer.app.Viewer
import badlog.viewer.compare.toggleCompared
import badlog.viewer.theme.LocalPalette

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
