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
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.catalog.folder.LogEntry
import badlog.files.writeAtomically
import badlog.viewer.panel.Extreme
import badlog.viewer.panel.Measured
import badlog.viewer.panel.MeasuredLine
import badlog.viewer.panel.NamedSpan
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.Table
import badlog.viewer.panel.Tone
import badlog.viewer.panel.folder.AcrossLog
import badlog.viewer.panel.folder.AcrossLogs
import badlog.viewer.panel.folder.acrossTools
import badlog.viewer.panel.folder.acrossTopics
import badlog.viewer.panel.rangeChoice
import badlog.viewer.panel.spanOf
import badlog.viewer.panel.statisticsOf
import badlog.viewer.panel.tsvOf
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.statistics.Channels
import badlog.viewer.state.Action
import badlog.viewer.state.FolderAction
import badlog.viewer.state.Request
import badlog.viewer.state.StatisticsState
import badlog.viewer.text.shortNames
import badlog.window.compare.ComparedRecordings
import badlog.window.compare.DrawnRecording
import badlog.window.files.FileChoice
import badlog.window.files.askToWrite
import badlog.window.log.AxisView
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.panel.ButtonsView
import badlog.window.panel.PanelView
import badlog.window.panel.PartView
import badlog.window.panel.WideTableView
import badlog.window.panel.extremeColor
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.withContext
import java.nio.file.Path

/** The statistics of every drawn topic, see [statisticsOf]. */
@Composable
internal fun StatisticsPanel(compared: ComparedRecordings, board: GraphBoard, view: AxisView, open: OpenRecording, modifier: Modifier) {
    val known by produceState<Pair<NamedSpan, List<Part>>?>(null, open) {
        // While the selection is dragged, only the latest that there was time for is calculated.
        snapshotFlow { statisticsInput(compared, board, view, open) }.conflate().map { asked ->
            withContext(Dispatchers.Default) { asked.part to asked.parts(open) }
        }.collect { value = it }
    }
    val (part, parts) = known ?: return
    Column(modifier) {
        Head(part, parts, view, open)
        PanelView(parts, goal = null, view::send, Modifier.weight(1f))
    }
}

@Composable
private fun Head(part: NamedSpan, parts: List<Part>, view: AxisView, open: OpenRecording) {
    Row(verticalAlignment = Alignment.CenterVertically) {
        PartView(rangeChoice(view.place, open.enabled, view.statistics), view::send, Modifier.weight(1f))
        ToolButton("Copy the statistics", Icons.Copy, text = "Copy") {
            view.send(Action.Ask(Request.Copy { tsvOf(parts.filterIsInstance<Table>(), part) }))
        }
    }
}

/** The input of the statistics; while it stays equal, nothing is recalculated. */
internal data class StatisticsInput(
    val drawn: List<DrawnRecording>,
    val graphs: List<List<String>>,
    val part: NamedSpan,
    val state: StatisticsState,
    val unfolded: Map<String, Boolean>,
) {
    /** Returns the statistics; [open] is the open recording. */
    fun parts(open: OpenRecording): List<Part> {
        val tables = graphs.flatten().distinct().map { name -> drawn.indices.mapNotNull { lineOf(name, it) } }.filter { it.isNotEmpty() }
        val hint = Paragraph("none", "No topic is drawn. Click one in the list of topics.", Tone.MUTED)
        val together = graphs.filter { it.size > 1 }.distinct().flatMap { lines ->
            drawn.indices.map { place -> lines.zip(shortNames(lines)).mapNotNull { (name, short) -> lineOf(name, place, short) } }
        }
        val measured = Measured(tables, together, Channels.of(open.view, open.signalTopics))
        return statisticsOf(measured, part, open.view.xAxis, state, unfolded) + listOfNotNull(hint.takeIf { tables.isEmpty() })
    }

    private fun lineOf(name: String, place: Int, short: String = name): MeasuredLine? {
        val (recording, offset, log) = drawn[place]
        val signal = recording.signal(name)?.takeIf { it.hasFigures || it.states != null } ?: return null
        return if (drawn.size > 1) MeasuredLine(signal.line, short, place, log, offset) else MeasuredLine(signal.line, short, color = null)
    }
}

/** Returns the current input for [open]. */
internal fun statisticsInput(compared: ComparedRecordings, board: GraphBoard, view: AxisView, open: OpenRecording) = StatisticsInput(
    compared.drawn,
    board.state.graphs.map { it.lines },
    view.place.spanOf(view.statistics.range, open.enabled),
    view.statistics,
    view.unfolded,
)

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
    view: AxisView,
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
        if (battery != null && view.across.topics.isEmpty()) view.send(FolderAction.MeasureAcross(view.across.toggled(battery)))
    }
    val state = view.across
    val made by produceState<AcrossSource?>(null, drawn, entries, state.isOverAll) {
        value = withContext(Dispatchers.Default) { acrossSource(drawn, acrossLogs(entries), state.isOverAll) }
    }
    val source = made ?: return Box(modifier.background(LocalPalette.current.surface))
    val rows by produceState(emptyList<AcrossLog>(), source, state.topics) {
        value = withContext(Dispatchers.Default) { source.logsOf(state.topics) }
    }
    val matching by produceState(emptyList<String>(), source, state.search, found) {
        value = withContext(Dispatchers.Default) { source.topicsFoundBy(Query(state.search), found) }
    }
    val send = { action: Action ->
        if (action is FolderAction.Open) onOpen(Path.of(action.path)) else view.send(action)
    }
    val logs = remember(rows, state.copy(search = "")) { AcrossLogs(rows, state) }
    val topics = remember(matching, state) { acrossTopics(state, matching) }
    val table = @Composable { place: Modifier ->
        Column(place) {
            FlowRow(
                Modifier.fillMaxWidth().padding(horizontal = 8.dp, vertical = 4.dp),
                itemVerticalAlignment = Alignment.CenterVertically,
            ) {
                ToolButton("The topics of the graphs, in their order", text = "Graphs") {
                    view.send(FolderAction.MeasureAcross(state.copy(topics = graphed.filter(source.topics::contains))))
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
