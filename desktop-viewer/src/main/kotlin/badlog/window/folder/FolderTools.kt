package badlog.window.folder

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.window.settings.SettingsStore
import badlog.window.theme.Icons
import badlog.window.theme.ToolButton

/**
 * The tools above the table or the charts of the folder's logs: filters, and the button for returning to the graphs.
 *
 * @param more the tools of the table or the charts.
 */
@Composable
internal fun FolderTools(library: Library, settings: SettingsStore, actions: LibraryActions, more: @Composable () -> Unit = {}) {
    BoxWithConstraints(Modifier.fillMaxWidth().padding(8.dp)) {
        val isNarrow = maxWidth < NARROW
        Column(verticalArrangement = Arrangement.spacedBy(6.dp)) {
            Row(horizontalArrangement = Arrangement.spacedBy(6.dp), verticalAlignment = Alignment.CenterVertically) {
                FolderMenu(library, settings, actions, if (isNarrow) Modifier.weight(1f) else Modifier.widthIn(max = 220.dp))
                if (!isNarrow) LogSearch(library, actions.open, Modifier.weight(1f))
                LogCount(library.state.listing)
                more()
                OnlyErrorsButton(library)
                HideEmptyButton(library)
                ToolButton("Back to the graphs", Icons.Graph, text = if (isNarrow) null else "Graphs") { actions.showGraphs() }
            }
            if (isNarrow) LogSearch(library, actions.open, Modifier.fillMaxWidth())
        }
    }
}

private val NARROW = 560.dp
