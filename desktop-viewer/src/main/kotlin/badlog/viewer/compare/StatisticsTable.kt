package badlog.viewer.compare

import androidx.compose.foundation.layout.Box
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import badlog.viewer.app.Viewer

/** A statistic of topics across recordings. */
@Composable
internal fun StatisticsTable(viewer: Viewer, modifier: Modifier = Modifier) {
    Box(modifier)
}
