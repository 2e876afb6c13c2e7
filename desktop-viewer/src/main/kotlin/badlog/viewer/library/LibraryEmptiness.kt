package badlog.viewer.library

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.app.Viewer
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton

/** What stands where logs would be listed if there were any. */
@Composable
internal fun LibraryEmptiness(viewer: Viewer, modifier: Modifier = Modifier) {
    Column(modifier.padding(16.dp), verticalArrangement = Arrangement.spacedBy(12.dp)) {
        Text(emptinessOf(viewer.library), color = LocalPalette.current.muted)
        if (viewer.library.listing.size == 0) {
            ToolButton("Open a folder of logs", Icons.Folder, text = "Open folder…") { chooseFolder(viewer) }
        } else {
            ToolButton("List all logs", Icons.Reset, text = "List all logs") {
                viewer.library = viewer.library.filtered("").hidingEmpty(false)
            }
        }
    }
}

private fun emptinessOf(library: LibraryState): String = when {
    library.folder == null -> "Open the folder where the robot’s logs are, or drop it onto this window."

    library.listing.size > 0 && library.listing.filter.isNotBlank() -> "No log has all of “${library.listing.filter.trim()}”."

    library.listing.size > 0 -> "Nothing happened in any of these logs."

    !library.hasLooked -> "Looking for logs…"

    library.reading != null -> "Reading the first logs…"

    library.trouble != null -> "No log is to be seen here."

    else ->
        "No logs here yet. Bags (.bag, .badbag), tables (.csv) and logs of WPILib (.wpilog) of this folder and the folders in it " +
            "are listed, also when they are compressed (.gz). A new one appears by itself."
}
