package badlog.viewer.statistics

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.material3.VerticalDivider
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.file.writeAtomically
import badlog.plot.search.Query
import badlog.plot.statistics.Statistic
import badlog.viewer.app.Viewer
import badlog.viewer.compare.drawnRecordings
import badlog.viewer.files.askToWrite
import badlog.viewer.panels.MainView
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.SearchField
import badlog.viewer.theme.Tip
import badlog.viewer.theme.ToolButton
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import java.nio.file.Path

/**
 * A statistic of topics across recordings.
 *
 * @param chooseFile asks where to save the table; null when the person gives it up.
 */
@Composable
internal fun StatisticsTable(
    viewer: Viewer,
    modifier: Modifier = Modifier,
    chooseFile: () -> Path? = { askToWrite(viewer, "Save the table", viewer.library.folder, "statistics", ".csv") },
) {
    LaunchedEffect(Unit) {
        // An empty table would tell nobody what it is for.
        val battery = viewer.library.entries.firstNotNullOfOrNull { it.batteryTopic }
        if (battery != null && viewer.statisticsChoice.topics.isEmpty()) {
            viewer.statisticsChoice = viewer.statisticsChoice.toggled(battery)
        }
    }
    val choice = viewer.statisticsChoice
    val drawn = viewer.drawnRecordings().map { it.recording }
    val logs = viewer.library.entries
    val found by produceState<StatisticsSource?>(null, drawn, logs, choice.isOverAll) {
        value = withContext(Dispatchers.Default) { statisticsSource(drawn, rowsOf(logs), choice.isOverAll) }
    }
    val source = found ?: return Box(modifier.background(LocalPalette.current.surface))
    val rows by produceState(emptyList<StatisticsRow>(), source, choice.topics) {
        value = withContext(Dispatchers.Default) { source.rowsOf(choice.topics) }
    }
    val grid = remember(rows, choice) { StatisticsGrid(rows, choice) }
    BoxWithConstraints(modifier.background(LocalPalette.current.surface)) {
        if (maxWidth < NARROW) {
            Column(Modifier.fillMaxSize()) {
                StatisticsTopics(viewer, source.topics, Modifier.fillMaxWidth().height(170.dp))
                HorizontalDivider()
                Table(viewer, source, grid, chooseFile, Modifier.weight(1f).fillMaxWidth())
            }
        } else {
            Row(Modifier.fillMaxSize()) {
                StatisticsTopics(viewer, source.topics, Modifier.width(240.dp).fillMaxHeight())
                VerticalDivider()
                Table(viewer, source, grid, chooseFile, Modifier.weight(1f).fillMaxHeight())
            }
        }
    }
}

@Composable
private fun Table(viewer: Viewer, source: StatisticsSource, grid: StatisticsGrid, chooseFile: () -> Path?, modifier: Modifier) {
    Column(modifier) {
        Head(viewer, grid, chooseFile)
        HorizontalDivider()
        when {
            source.topics.isEmpty() -> TableHint("Open a log, and tick others to compare it with.")
            viewer.statisticsChoice.topics.isEmpty() -> TableHint("Choose topics; each gets a column for each statistic.")
            else -> StatisticsRows(viewer, grid, Modifier.fillMaxSize())
        }
    }
}

@Composable
private fun Head(viewer: Viewer, grid: StatisticsGrid, chooseFile: () -> Path?) {
    val choice = viewer.statisticsChoice
    FlowRow(Modifier.fillMaxWidth().padding(horizontal = 8.dp, vertical = 4.dp), itemVerticalAlignment = Alignment.CenterVertically) {
        ToolButton("The open log and those that are ticked", text = "Ticked", isOn = !choice.isOverAll) {
            viewer.statisticsChoice = viewer.statisticsChoice.copy(isOverAll = false)
        }
        ToolButton("Every log of the folder", text = "All", isOn = choice.isOverAll, modifier = Modifier.padding(end = 16.dp)) {
            viewer.statisticsChoice = viewer.statisticsChoice.copy(isOverAll = true)
        }
        for (statistic in Statistic.entries) {
            ToolButton("Column ${statistic.title}", text = statistic.title, isOn = statistic in choice.statistics) {
                viewer.statisticsChoice = viewer.statisticsChoice.toggled(statistic)
            }
        }
        Legend("smallest", LocalPalette.current.warningSoft)
        Legend("largest", LocalPalette.current.accentSoft)
        ToolButton("Save the table as CSV", Icons.Share, text = "CSV", isEnabled = choice.topics.isNotEmpty()) {
            chooseFile()?.let { saveCsv(viewer, grid, it) }
        }
        ToolButton("Back to the graphs", Icons.Close) { viewer.panels = viewer.panels.copy(main = MainView.GRAPHS) }
    }
}

/** Says what [color] means behind a figure. */
@Composable
private fun Legend(text: String, color: Color) {
    Text(
        text,
        Modifier.padding(horizontal = 6.dp).background(color, RoundedCornerShape(4.dp)).padding(horizontal = 6.dp, vertical = 1.dp),
        color = LocalPalette.current.muted,
        fontSize = 12.sp,
    )
}

@Composable
private fun TableHint(text: String) {
    Text(text, Modifier.padding(16.dp), color = LocalPalette.current.muted)
}

private val NARROW = 640.dp

/** Chooses among [topics] those that the table has; the chosen ones stand first, as they always must be found. */
@Composable
internal fun StatisticsTopics(viewer: Viewer, topics: List<String>, modifier: Modifier) {
    var query by remember { mutableStateOf("") }
    val chosen = viewer.statisticsChoice.topics
    val listed = remember(topics, query, chosen) {
        val found = topics.filter(Query(query)::matches)
        chosen + (found - chosen.toSet())
    }
    val state = rememberLazyListState()
    Column(modifier) {
        SearchField(query, "Search topics for the table", Modifier.fillMaxWidth().padding(8.dp)) { query = it }
        Box(Modifier.fillMaxSize()) {
            LazyColumn(Modifier.fillMaxSize(), state) {
                items(listed) { topic ->
                    TopicChoice(topic, topic in chosen) { viewer.statisticsChoice = viewer.statisticsChoice.toggled(topic) }
                }
            }
            VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        }
    }
}

@Composable
private fun TopicChoice(topic: String, isChosen: Boolean, onClick: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .fillMaxWidth()
            .background(if (isChosen) palette.accentSoft else Color.Transparent)
            .clickable(onClick = onClick)
            .semantics {
                contentDescription = "Figures of $topic"
                selected = isChosen
            }
            .padding(horizontal = 8.dp, vertical = 4.dp),
        Arrangement.spacedBy(6.dp),
        Alignment.CenterVertically,
    ) {
        Box(Modifier.size(14.dp)) {
            if (isChosen) Icon(Icons.Check, contentDescription = null, Modifier.size(14.dp), palette.accent)
        }
        Tip(topic, Modifier.weight(1f)) { Text(topic, maxLines = 1, overflow = TextOverflow.Ellipsis) }
    }
}

/** Saves [grid] as CSV into [file]. */
internal fun saveCsv(viewer: Viewer, grid: StatisticsGrid, file: Path) {
    viewer.tasks.run("Saving ${file.fileName}", { writeAtomically(file) { it.write(grid.toCsv().encodeToByteArray()) } }) {
        viewer.notices.say("The table is saved in $file.")
    }
}
