package badlog.window.sidebar

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
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.catalog.folder.LogEntry
import badlog.files.writeAtomically
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.statistics.Statistic
import badlog.window.files.FileChoice
import badlog.window.files.askToWrite
import badlog.window.log.OpenRecording
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.SearchField
import badlog.window.theme.Tip
import badlog.window.theme.ToolButton
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import java.nio.file.Path

/**
 * A table with statistics of topics across logs.
 *
 * @param entries the logs of the folder.
 * @param drawn the open log and the compared ones.
 * @param found the names of the topics that a finding is about.
 * @param graphed the names of the drawn topics.
 * @param onOpen shows the log of a row.
 * @param onSave saves the table.
 * @param onClose shows the graphs again.
 */
@Composable
internal fun StatisticsTable(
    statistics: SelectedStatistics,
    entries: List<LogEntry>,
    drawn: List<OpenRecording>,
    found: Set<String>,
    graphed: List<String>,
    onOpen: (Path) -> Unit,
    onSave: (StatisticsGrid) -> Unit,
    onClose: () -> Unit,
    modifier: Modifier = Modifier,
) {
    LaunchedEffect(Unit) {
        // An empty table would not explain itself.
        val battery = entries.firstNotNullOfOrNull { it.summary.batteryTopic }
        if (battery != null && statistics.state.topics.isEmpty()) {
            statistics.change { toggled(battery) }
        }
    }
    val choice = statistics.state
    val made by produceState<StatisticsSource?>(null, drawn, entries, choice.isOverAll) {
        value = withContext(Dispatchers.Default) { statisticsSource(drawn, rowsOf(entries), choice.isOverAll) }
    }
    val source = made ?: return Box(modifier.background(LocalPalette.current.surface))
    val rows by produceState(emptyList<StatisticsRow>(), source, choice.topics) {
        value = withContext(Dispatchers.Default) { source.rowsOf(choice.topics) }
    }
    val actions = TableActions(onOpen, onSave, onClose) { statistics.change { copy(topics = graphed.filter(source.topics::contains)) } }
    val grid = remember(rows, choice) { StatisticsGrid(rows, choice) }
    BoxWithConstraints(modifier.background(LocalPalette.current.surface)) {
        if (maxWidth < NARROW) {
            Column(Modifier.fillMaxSize()) {
                StatisticsTopics(statistics, source, found, Modifier.fillMaxWidth().height(170.dp))
                HorizontalDivider()
                Table(statistics, source, grid, drawn.firstOrNull()?.file, actions, Modifier.weight(1f).fillMaxWidth())
            }
        } else {
            Row(Modifier.fillMaxSize()) {
                StatisticsTopics(statistics, source, found, Modifier.width(240.dp).fillMaxHeight())
                VerticalDivider()
                Table(statistics, source, grid, drawn.firstOrNull()?.file, actions, Modifier.weight(1f).fillMaxHeight())
            }
        }
    }
}

@Composable
private fun Table(
    statistics: SelectedStatistics,
    source: StatisticsSource,
    grid: StatisticsGrid,
    open: Path?,
    actions: TableActions,
    modifier: Modifier,
) {
    Column(modifier) {
        Head(statistics, grid, actions)
        HorizontalDivider()
        when {
            source.topics.isEmpty() -> TableHint("Open a log, and check others to compare it with.")
            statistics.state.topics.isEmpty() -> TableHint("Select topics; each gets a column for each statistic.")
            else -> StatisticsRows(statistics, grid, open, actions.open, Modifier.fillMaxSize())
        }
    }
}

private class TableActions(val open: (Path) -> Unit, val save: (StatisticsGrid) -> Unit, val close: () -> Unit, val takeGraphs: () -> Unit)

@Composable
private fun Head(statistics: SelectedStatistics, grid: StatisticsGrid, actions: TableActions) {
    val choice = statistics.state
    FlowRow(Modifier.fillMaxWidth().padding(horizontal = 8.dp, vertical = 4.dp), itemVerticalAlignment = Alignment.CenterVertically) {
        ToolButton("The open log and those that are checked", text = "Checked", isOn = !choice.isOverAll) {
            statistics.change { copy(isOverAll = false) }
        }
        ToolButton("Every log of the folder", text = "All", isOn = choice.isOverAll, modifier = Modifier.padding(end = 16.dp)) {
            statistics.change { copy(isOverAll = true) }
        }
        ToolButton("The topics of the graphs, in their order", text = "Graphs", modifier = Modifier.padding(end = 16.dp)) {
            actions.takeGraphs()
        }
        for (statistic in Statistic.entries) {
            ToolButton("Column ${statistic.title}", text = statistic.title, isOn = statistic in choice.statistics) {
                statistics.change { toggled(statistic) }
            }
        }
        Legend("smallest", LocalPalette.current.warningSoft)
        Legend("largest", LocalPalette.current.accentSoft)
        ToolButton("Save the table as CSV", Icons.Share, text = "CSV", isEnabled = choice.topics.isNotEmpty()) {
            actions.save(grid)
        }
        ToolButton("Back to the graphs", Icons.Close) { actions.close() }
    }
}

/** Explains the meaning of [color] behind a value. */
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

/** Selects topics of [source] for the table; the selected ones come first, so that they can always be found. */
@Composable
internal fun StatisticsTopics(statistics: SelectedStatistics, source: StatisticsSource, found: Set<String>, modifier: Modifier) {
    var query by remember { mutableStateOf("") }
    val selected = statistics.state.topics
    val matching by produceState(emptyList<String>(), source, query, found) {
        value = withContext(Dispatchers.Default) { source.topicsFoundBy(Query(query), found) }
    }
    val listed = remember(matching, selected) { selected + (matching - selected.toSet()) }
    val state = rememberLazyListState()
    Column(modifier) {
        SearchField(query, "Search topics for the table", Modifier.fillMaxWidth().padding(8.dp)) { query = it }
        Box(Modifier.fillMaxSize()) {
            LazyColumn(Modifier.fillMaxSize(), state) {
                items(listed) { topic ->
                    TopicChoice(topic, topic in selected) { statistics.change { toggled(topic) } }
                }
            }
            VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        }
    }
}

@Composable
private fun TopicChoice(topic: String, isSelected: Boolean, onClick: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .fillMaxWidth()
            .background(if (isSelected) palette.accentSoft else Color.Transparent)
            .clickable(onClick = onClick)
            .semantics {
                contentDescription = "Statistics of $topic"
                selected = isSelected
            }
            .padding(horizontal = 8.dp, vertical = 4.dp),
        Arrangement.spacedBy(6.dp),
        Alignment.CenterVertically,
    ) {
        Box(Modifier.size(14.dp)) {
            if (isSelected) Icon(Icons.Check, contentDescription = null, Modifier.size(14.dp), palette.accent)
        }
        Tip(topic, Modifier.weight(1f)) { NameText(topic) }
    }
}

/** Saves tables of statistics as CSV files that the person names. */
internal class TableSaver(private val files: FileChoice, private val tasks: LongTasks, private val notices: Notices) {
    /** Asks for a file, starting in [folder], and writes [grid] to it. */
    fun save(grid: StatisticsGrid, folder: Path?) {
        val file = askToWrite(files, notices, "Save the table", folder, "statistics", ".csv") ?: return
        tasks.run("Saving ${file.fileName}", { writeAtomically(file) { it.write(grid.toCsv().encodeToByteArray()) } }) {
            notices.say("Saved the table to $file.")
        }
    }
}
