package badlog.window.sidebar

import androidx.compose.foundation.background
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
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.HorizontalDivider
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
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.catalog.folder.LogEntry
import badlog.files.writeAtomically
import badlog.viewer.panel.Extreme
import badlog.viewer.panel.folder.AcrossLog
import badlog.viewer.panel.folder.AcrossLogs
import badlog.viewer.panel.folder.acrossTools
import badlog.viewer.panel.folder.acrossTopics
import badlog.viewer.shown.search.Query
import badlog.viewer.state.AcrossState
import badlog.viewer.state.Action
import badlog.viewer.state.FolderAction
import badlog.window.files.FileChoice
import badlog.window.files.askToWrite
import badlog.window.log.OpenRecording
import badlog.window.panel.ButtonsView
import badlog.window.panel.PanelView
import badlog.window.panel.WideTableView
import badlog.window.panel.extremeColor
import badlog.window.state.StateHolder
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import java.nio.file.Path

/** The choices for the window's statistics across logs. */
internal class AcrossChoice : StateHolder<AcrossState>(AcrossState())

/**
 * The statistics of topics across logs.
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
internal fun AcrossPane(
    across: AcrossChoice,
    entries: List<LogEntry>,
    drawn: List<OpenRecording>,
    found: Set<String>,
    graphed: List<String>,
    onOpen: (Path) -> Unit,
    onSave: (AcrossLogs) -> Unit,
    onClose: () -> Unit,
    modifier: Modifier = Modifier,
) {
    LaunchedEffect(Unit) {
        // An empty table would not explain itself.
        val battery = entries.firstNotNullOfOrNull { it.summary.batteryTopic }
        if (battery != null && across.state.topics.isEmpty()) across.change { toggled(battery) }
    }
    val state = across.state
    var search by remember { mutableStateOf("") }
    val made by produceState<AcrossSource?>(null, drawn, entries, state.isOverAll) {
        value = withContext(Dispatchers.Default) { acrossSource(drawn, acrossLogs(entries), state.isOverAll) }
    }
    val source = made ?: return Box(modifier.background(LocalPalette.current.surface))
    val rows by produceState(emptyList<AcrossLog>(), source, state.topics) {
        value = withContext(Dispatchers.Default) { source.logsOf(state.topics) }
    }
    val matching by produceState(emptyList<String>(), source, search, found) {
        value = withContext(Dispatchers.Default) { source.topicsFoundBy(Query(search), found) }
    }
    val send = { action: Action ->
        when (action) {
            is FolderAction.MeasureAcross -> across.change { action.state }
            is FolderAction.SearchAcross -> search = action.text
            is FolderAction.Open -> onOpen(Path.of(action.path))
            else -> Unit
        }
    }
    val logs = remember(rows, state) { AcrossLogs(rows, state) }
    val topics = remember(matching, search, state) { acrossTopics(state, matching, search) }
    val table = @Composable { place: Modifier ->
        Column(place) {
            FlowRow(
                Modifier.fillMaxWidth().padding(horizontal = 8.dp, vertical = 4.dp),
                itemVerticalAlignment = Alignment.CenterVertically,
            ) {
                ToolButton("The topics of the graphs, in their order", text = "Graphs") {
                    across.change { copy(topics = graphed.filter(source.topics::contains)) }
                }
                ButtonsView(acrossTools(state), send)
                for (extreme in Extreme.entries) Legend(extreme)
                ToolButton("Save the table as CSV", Icons.Share, text = "CSV", isEnabled = state.topics.isNotEmpty()) { onSave(logs) }
                ToolButton("Back to the graphs", Icons.Close) { onClose() }
            }
            HorizontalDivider()
            when {
                source.topics.isEmpty() -> PanelHint("Open a log, and check others to compare it with.")
                state.topics.isEmpty() -> PanelHint("Select topics; each gets a column for each statistic.")
                else -> WideTableView(remember(logs) { logs.table() }, send, open = drawn.firstOrNull()?.file?.toString()) {}
            }
        }
    }
    BoxWithConstraints(modifier.background(LocalPalette.current.surface)) {
        if (maxWidth < NARROW) {
            Column(Modifier.fillMaxSize()) {
                PanelView(topics, goal = null, send, Modifier.fillMaxWidth().height(170.dp))
                HorizontalDivider()
                table(Modifier.weight(1f).fillMaxWidth())
            }
        } else {
            Row(Modifier.fillMaxSize()) {
                PanelView(topics, goal = null, send, Modifier.width(240.dp).fillMaxHeight())
                VerticalDivider()
                table(Modifier.weight(1f).fillMaxHeight())
            }
        }
    }
}

/** Explains the color behind an [extreme]. */
@Composable
private fun Legend(extreme: Extreme) {
    val palette = LocalPalette.current
    Text(
        extreme.name.lowercase(),
        Modifier
            .padding(horizontal = 6.dp)
            .background(extremeColor(extreme, palette), RoundedCornerShape(4.dp))
            .padding(horizontal = 6.dp, vertical = 1.dp),
        color = palette.muted,
        fontSize = 12.sp,
    )
}

private val NARROW = 640.dp

/** Saves tables of statistics as CSV files that the person names. */
internal class TableSaver(private val files: FileChoice, private val tasks: LongTasks, private val notices: Notices) {
    /** Asks for a file, starting in [folder], and writes [table] to it. */
    fun save(table: AcrossLogs, folder: Path?) {
        val file = askToWrite(files, notices, "Save the table", folder, "statistics", ".csv") ?: return
        tasks.run("Saving ${file.fileName}", { writeAtomically(file) { it.write(table.csv().encodeToByteArray()) } }) {
            notices.say("Saved the table to $file.")
        }
    }
}
