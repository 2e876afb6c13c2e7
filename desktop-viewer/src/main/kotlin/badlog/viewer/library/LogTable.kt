package badlog.viewer.library

import androidx.compose.foundation.layout.Box
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import badlog.viewer.app.Viewer

/** Every log of the folder with all its columns. */
@Composable
internal fun LogTable(viewer: Viewer, modifier: Modifier = Modifier) {
    Box(modifier)
}
