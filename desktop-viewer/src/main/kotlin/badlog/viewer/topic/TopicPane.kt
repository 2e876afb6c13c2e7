package badlog.viewer.topic

import androidx.compose.foundation.layout.Box
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import badlog.viewer.app.Viewer

/** The topics of the open recording by folder. */
@Composable
internal fun TopicPane(viewer: Viewer, modifier: Modifier = Modifier) {
    Box(modifier)
}
