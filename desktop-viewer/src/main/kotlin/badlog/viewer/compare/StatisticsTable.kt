package badlog.viewer.compare

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.material3.VerticalDivider
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.app.MainView
import badlog.viewer.app.Viewer
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton
import java.nio.file.Path
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext

/**
 * A statistic of topics across recordings.
 *
 * @param chooseFile asks where to save what is called so; null when the person gives it up.
 */
@Composable
internal fun StatisticsTable(viewer: Viewer, modifier: Modifier = Modifier, chooseFile: (String) -> Path? = ::chooseFileToSave) {
    val open = viewer.open
    val comparison = viewer.comparison
    val source = remember(open, comparison.ticked, comparison.loaded) { statisticsSource(viewer) }
    val choice = viewer.statisticsChoice
    val rows by produceState(emptyList<StatisticsRow>(), source, choice.topics) {
        value = withContext(Dispatchers.Default) { source.rowsOf(choice.topics) }
    }
    val grid = remember(rows, choice) { StatisticsGrid(rows, choice) }
    Row(modifier.background(LocalPalette.current.surface)) {
        StatisticsTopics(viewer, source.topics, Modifier.width(240.dp).fillMaxHeight())
        VerticalDivider()
        Column(Modifier.weight(1f)) {
            Head(viewer, grid, chooseFile)
            HorizontalDivider()
            when {
                source.topics.isEmpty() -> TableHint("Open a log, and tick others to compare it with.")
                choice.topics.isEmpty() -> TableHint("Choose topics at the left; each gets a column for each statistic.")
                else -> StatisticsRows(viewer, grid, Modifier.fillMaxSize())
            }
        }
    }
}

@Composable
private fun Head(viewer: Viewer, grid: StatisticsGrid, chooseFile: (String) -> Path?) {
    val choice = viewer.statisticsChoice
    Row(Modifier.fillMaxWidth().padding(start = 8.dp, end = 4.dp, top = 4.dp, bottom = 4.dp), verticalAlignment = Alignment.CenterVertically) {
        FlowRow(Modifier.weight(1f)) {
            for (statistic in Statistic.entries) {
                ToolButton("Column ${statistic.title}", text = statistic.title, isOn = statistic in choice.statistics) {
                    viewer.statisticsChoice = viewer.statisticsChoice.toggled(statistic)
                }
            }
        }
        ToolButton("Save the table as CSV", Icons.Share, text = "CSV", isEnabled = choice.topics.isNotEmpty()) {
            chooseFile("statistics.csv")?.let { saveCsv(viewer, grid, it) }
        }
        ToolButton("Back to the graphs", Icons.Close) { viewer.panels = viewer.panels.copy(main = MainView.GRAPHS) }
    }
}

@Composable
private fun TableHint(text: String) {
    Text(text, Modifier.padding(16.dp), color = LocalPalette.current.muted)
}
