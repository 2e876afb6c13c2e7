package badlog.viewer.graph

import androidx.compose.foundation.layout.Box
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import badlog.viewer.app.Viewer

/** The graphs of the open recording, with overview and playback. */
@Composable
internal fun GraphPane(viewer: Viewer, modifier: Modifier = Modifier) {
    Box(modifier)
}
