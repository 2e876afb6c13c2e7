package badlog.window.battery

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import badlog.viewer.panel.folder.recordedBatteriesPanel
import badlog.window.folder.FolderPane
import badlog.window.folder.Library
import badlog.window.folder.LibraryActions
import badlog.window.log.AxisView

/** The team's batteries in the folder's logs, see [recordedBatteriesPanel]. */
@Composable
internal fun BatteriesPane(season: FolderSeason, library: Library, view: AxisView, actions: LibraryActions, modifier: Modifier = Modifier) {
    val batteries = season.state
    val isReading = library.state.reading != null
    LaunchedEffect(season) { season.refresh() }
    val parts = remember(batteries, view.unfolded, isReading) {
        recordedBatteriesPanel(batteries.seasons, view.unfolded, batteries.problems, isReading)
    }
    FolderPane(parts, library, actions, view::send, modifier)
}
