package badlog.viewer.inspector

import androidx.compose.foundation.layout.Box
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import badlog.viewer.app.Viewer

/** The panel at the right: events, values, problems, statistics. */
@Composable
internal fun InspectorPane(viewer: Viewer, modifier: Modifier = Modifier) {
    Box(modifier)
}
