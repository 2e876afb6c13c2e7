package badlog.viewer.findings

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.recording.Severity
import badlog.viewer.app.Viewer
import badlog.viewer.compare.drawnRecordings
import badlog.viewer.inspector.EventTimes
import badlog.viewer.inspector.PanelHint
import badlog.viewer.inspector.countText
import badlog.viewer.recording.OpenRecording
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton

/** What rules found in [open], by time; a click on a line goes there. Below it the rules that could not be asked, folded. */
@Composable
internal fun FindingsPanel(viewer: Viewer, open: OpenRecording, modifier: Modifier) {
    val findings = viewer.findings
    val list = findings.list
    if (list == null) {
        PanelHint("The rules are being run …")
        return
    }
    val times = remember(open) { EventTimes(open) }
    var showsSkipped by remember { mutableStateOf(false) }
    val state = rememberLazyListState()
    LaunchedEffect(findings.chosen) {
        val index = list.all.indexOf(findings.chosen)
        val visible = state.layoutInfo.visibleItemsInfo
        if (index >= 0 && visible.none { it.index == index }) state.scrollToItem(maxOf(0, index - visible.size / 2))
    }
    Column(modifier) {
        Row(Modifier.fillMaxWidth().padding(start = 12.dp, end = 4.dp, top = 4.dp), verticalAlignment = Alignment.CenterVertically) {
            Text(summaryOf(list), Modifier.weight(1f), fontWeight = FontWeight.Medium)
            ToolButton("To the finding before (${BEFORE.text})", Icons.Up, isEnabled = list.placed.isNotEmpty()) { stepFinding(viewer, -1) }
            ToolButton("To the next finding (${NEXT.text})", Icons.Down, isEnabled = list.placed.isNotEmpty()) { stepFinding(viewer, 1) }
            ToolButton("Run the rules again", Icons.Reset) {
                viewer.findings = findings.copy(timesAsked = findings.timesAsked + 1)
            }
        }
        Small("Rules: ${list.rulesFile?.let { "${it.fileName} in ${it.parent.fileName}" } ?: "those that badlog brings along"}.")
        if (viewer.drawnRecordings().size > 1) Small("Of the open log alone, not of those it is compared with.")
        list.trouble?.let { Box(Modifier.padding(horizontal = 12.dp, vertical = 4.dp)) { PointedText(it) } }
        Box(Modifier.weight(1f)) {
            LazyColumn(Modifier.fillMaxSize(), state) {
                items(list.all) { FindingLine(it, times, isChosen = it === findings.chosen) { goTo(viewer, it) } }
                if (list.skipped.isNotEmpty()) {
                    item { SkippedHead(list.skipped.size, showsSkipped) { showsSkipped = !showsSkipped } }
                    if (showsSkipped) items(list.skipped) { SkippedLine(it) }
                }
            }
            VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        }
    }
}

/** `1 error, 5 warnings, 2 notes`, only of what there is. */
internal fun summaryOf(list: FindingList): String = Severity.entries.reversed()
    .map { severity -> severity to list.all.count { it.severity == severity } }
    .filter { it.second > 0 }
    .joinToString { (severity, count) -> countText(count, severity.word) }
    .ifEmpty { if (list.trouble == null) "Nothing was found." else "" }

@Composable
private fun Small(text: String) {
    Text(text, Modifier.padding(horizontal = 12.dp, vertical = 2.dp), color = LocalPalette.current.muted, fontSize = 12.sp)
}
