package badlog.viewer.library

import androidx.compose.foundation.layout.Box
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import badlog.viewer.app.Viewer

/** The list of logs at the left. */
@Composable
internal fun LibraryPane(viewer: Viewer, modifier: Modifier = Modifier) {
    Box(modifier)
}
