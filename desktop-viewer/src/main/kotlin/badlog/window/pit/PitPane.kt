package badlog.window.pit

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.TextUnit
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.catalog.folder.LogEntry
import badlog.viewer.shown.folder.PitLogs
import badlog.viewer.shown.folder.pitEmptiness
import badlog.viewer.shown.folder.pitFacts
import badlog.viewer.shown.folder.verdictText
import badlog.window.battery.Batteries
import badlog.window.battery.FolderSeason
import badlog.window.battery.PitBatteries
import badlog.window.findings.findingColor
import badlog.window.findings.findingSoft
import badlog.window.folder.Library
import badlog.window.folder.LibraryActions
import badlog.window.folder.ReadingLine
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.Palette
import badlog.window.theme.ToolButton
import badlog.window.todo.FolderTodo
import badlog.window.todo.PitTodo

/** The pit view, for a look between two matches: the last log and earlier ones. The letters can be read from two meters away. */
@Composable
internal fun PitPane(library: Library, season: FolderSeason, todo: FolderTodo, actions: LibraryActions, modifier: Modifier = Modifier) {
    val entries = library.state.entries
    LaunchedEffect(season) { season.refresh() }
    val logs = remember(entries) { PitLogs.of(library.state.ofRobots) }
    Column(modifier.background(LocalPalette.current.surface).semantics { contentDescription = "Pit view" }) {
        Row(Modifier.fillMaxWidth().padding(8.dp), Arrangement.End) {
            ToolButton("Back to the graphs", Icons.Graph, text = "Graphs") { actions.showGraphs() }
        }
        ReadingLine(library)
        if (logs == null) {
            val isReading = library.state.folder != null && (!library.state.hasLooked || library.state.reading != null)
            Large(pitEmptiness(entries, isReading), Modifier.padding(24.dp))
        } else {
            BoxWithConstraints(Modifier.fillMaxSize()) { PitLogsPane(logs, season.state, todo, isNarrow = maxWidth < NARROW, actions) }
        }
    }
}

/** The [logs] beside each other, or below each other in a narrow window. */
@Composable
private fun PitLogsPane(logs: PitLogs<LogEntry>, batteries: Batteries, todo: FolderTodo, isNarrow: Boolean, actions: LibraryActions) {
    val earlier = @Composable { log: LogEntry, modifier: Modifier -> EarlierLog(log, modifier) { actions.openFindings(log) } }
    Column(Modifier.fillMaxSize().padding(horizontal = 24.dp).verticalScroll(rememberScrollState()), Arrangement.spacedBy(16.dp)) {
        LastLog(logs.last) { actions.openFindings(logs.last) }
        PitBatteries(batteries, actions.toggleBatteries)
        PitTodo(todo, actions.toggleTodo)
        if (isNarrow) {
            for (log in logs.before) earlier(log, Modifier.fillMaxWidth())
        } else {
            Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(16.dp)) { for (log in logs.before) earlier(log, Modifier.weight(1f)) }
        }
        Spacer(Modifier.height(8.dp))
    }
}

@Composable
private fun LastLog(log: LogEntry, onOpen: () -> Unit) {
    val palette = LocalPalette.current
    val verdict = log.found?.verdict
    Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(12.dp)) {
        FlowRow(Modifier.fillMaxWidth(), Arrangement.SpaceBetween, itemVerticalAlignment = Alignment.Bottom) {
            Large(log.title, Modifier.padding(end = 24.dp), TITLE, weight = FontWeight.SemiBold)
            Large(pitFacts(log), Modifier, SMALL, palette.muted)
        }
        Column(
            Modifier
                .fillMaxWidth()
                .background(log.softColor(palette), RoundedCornerShape(12.dp))
                .clickable(role = Role.Button, onClickLabel = "Show what was found in ${log.title}", onClick = onOpen)
                .padding(24.dp),
            Arrangement.spacedBy(16.dp),
        ) {
            Large(verdictText(log.found), Modifier, HEADLINE, log.color(palette), FontWeight.Bold)
            for (sentence in verdict?.sentences.orEmpty()) Large(sentence)
            verdict?.next?.takeIf { it.isNotEmpty() }?.let { Large("Next: $it", weight = FontWeight.SemiBold) }
        }
    }
}

@Composable
private fun EarlierLog(log: LogEntry, modifier: Modifier, onOpen: () -> Unit) {
    val palette = LocalPalette.current
    Column(
        modifier
            .background(log.softColor(palette), RoundedCornerShape(12.dp))
            .clickable(role = Role.Button, onClickLabel = "Show what was found in ${log.title}", onClick = onOpen)
            .padding(16.dp),
        Arrangement.spacedBy(4.dp),
    ) {
        NameText(log.title, fontSize = SMALL, fontWeight = FontWeight.SemiBold, cut = NameCut.MIDDLE)
        Large(verdictText(log.found), Modifier, SMALL, log.color(palette), lines = 2)
    }
}

@Composable
private fun Large(
    text: String,
    modifier: Modifier = Modifier,
    size: TextUnit = BODY,
    color: Color = LocalPalette.current.text,
    weight: FontWeight = FontWeight.Normal,
    lines: Int = 3,
) = Text(
    text,
    modifier,
    color,
    fontSize = size,
    fontWeight = weight,
    lineHeight = size * LINE,
    maxLines = lines,
    overflow = TextOverflow.Ellipsis,
)

private fun LogEntry.color(palette: Palette) = found?.verdict?.let { palette.findingColor(it.severity) } ?: palette.text

private fun LogEntry.softColor(palette: Palette) = found?.verdict?.let { palette.findingSoft(it.severity) } ?: palette.raised

private val HEADLINE = 56.sp
private val TITLE = 40.sp
private val BODY = 28.sp
private val SMALL = 24.sp
private const val LINE = 1.25
private val NARROW = 720.dp
