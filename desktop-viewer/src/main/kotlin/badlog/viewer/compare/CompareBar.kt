package badlog.viewer.compare

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.app.Viewer
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton
import androidx.compose.ui.Alignment as Place

/** What is compared with the open recording, and how it is aligned; nothing while nothing is. */
@Composable
internal fun CompareBar(viewer: Viewer) {
    val open = viewer.open ?: return
    val comparison = viewer.comparison
    if (comparison.ticked.all { it == open.file }) return
    val palette = LocalPalette.current
    Column(Modifier.fillMaxWidth().background(palette.surface)) {
        FlowRow(
            Modifier.fillMaxWidth().padding(start = 12.dp, end = 4.dp, top = 2.dp, bottom = 2.dp),
            itemVerticalAlignment = Place.CenterVertically,
        ) {
            Text("Align at", Modifier.padding(end = 6.dp), color = palette.muted)
            for (alignment in Alignment.entries) {
                ToolButton(alignment.hint, text = alignment.title, isOn = alignment == comparison.alignment) {
                    viewer.comparison = viewer.comparison.alignedBy(alignment, open)
                }
            }
            ToolButton("Compare with none", Icons.Close, text = "Clear") { viewer.comparisonLoading.clear() }
        }
        FlowRow(
            Modifier
                .fillMaxWidth()
                .heightIn(max = 140.dp)
                .verticalScroll(rememberScrollState())
                .padding(start = 8.dp, end = 8.dp, bottom = 6.dp),
            Arrangement.spacedBy(6.dp),
            Arrangement.spacedBy(4.dp),
        ) {
            viewer.drawnRecordings().forEachIndexed { index, drawn -> ComparedChip(viewer, open, drawn, palette.colorOf(index)) }
            for (file in comparison.ticked) {
                if (file != open.file && file !in comparison.loaded) {
                    Row(Modifier.padding(horizontal = 8.dp, vertical = 6.dp)) {
                        Text("Reading ${file.fileName} …".take(60), color = palette.muted, maxLines = 1)
                    }
                }
            }
        }
        HorizontalDivider()
    }
}
