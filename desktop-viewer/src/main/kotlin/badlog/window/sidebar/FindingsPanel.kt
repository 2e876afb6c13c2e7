package badlog.window.sidebar

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.catalog.folder.LogEntry
import badlog.rules.Finding
import badlog.rules.SkippedRule
import badlog.viewer.input.Action
import badlog.viewer.shown.finding.SearchedFindings
import badlog.viewer.shown.folder.Changes
import badlog.viewer.text.countText
import badlog.viewer.text.word
import badlog.viewer.todo.taskOf
import badlog.window.compare.ComparedRecordings
import badlog.window.findings.FindingList
import badlog.window.findings.LogFindings
import badlog.window.findings.findingColor
import badlog.window.findings.findingSoft
import badlog.window.log.AxisView
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.menu.ContextArea
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.SearchField
import badlog.window.theme.ToolButton
import badlog.window.todo.FolderTodo
import badlog.window.todo.TodoButtons
import badlog.window.todo.TodoMark
import badlog.window.todo.todoMenu

/**
 * The findings in [open], incidents first, then the worst; a click on a line goes there and shows its evidence. Below are the skipped
 * rules, folded.
 *
 * @param changes how the log differs from the ones before it.
 * @param perform does what a key does.
 * @param onGo called when a click goes to a finding.
 */
@Composable
internal fun FindingsPanel(
    compared: ComparedRecordings,
    findings: LogFindings,
    todo: FolderTodo,
    view: AxisView,
    board: GraphBoard,
    open: OpenRecording,
    changes: Changes<LogEntry>,
    perform: (Action) -> Unit,
    onGo: () -> Unit,
    modifier: Modifier,
) {
    val selected = findings.selected
    val list = findings.state.list
    if (list == null) {
        PanelHint("Running the rules…")
        return
    }
    val times = remember(open) { EventTimes(open) }
    var query by remember(open.file) { mutableStateOf("") }
    val found = remember(list, query) { list.foundBy(query) }
    val names = remember(open) { open.view.recording.topics.filter { it.size > 0 }.map { it.name }.sorted() }
    var showsWithin by remember(open.file) { mutableStateOf(false) }
    var showsSkipped by remember { mutableStateOf(false) }
    val state = rememberLazyListState()
    fun goTo(finding: Finding) {
        findings.goTo(finding)
        onGo()
    }
    LaunchedEffect(selected, found) {
        if (selected !in found.findings) return@LaunchedEffect
        // The height of its details is known only after layout.
        withFrameNanos { }
        val visible = state.layoutInfo.visibleItemsInfo
        // Somebody who goes to a finding of an incident reads the incident, unless it was chosen among the findings below.
        val incident = found.incidents.indexOfFirst { selected in it.causes + it.effects }
        val row = found.incidents.size + found.beside.outside.indexOf(selected)
        val isRead = incident >= 0 && visible.any { it.key === selected }
        if (!isRead) showWhole(state, if (incident >= 0) incident else row)
    }
    Column(modifier) {
        Row(Modifier.fillMaxWidth().padding(start = 12.dp, end = 4.dp, top = 4.dp), verticalAlignment = Alignment.CenterVertically) {
            Text(summaryOf(list, found), Modifier.weight(1f), fontWeight = FontWeight.Medium)
            ToolButton("Previous finding (${Action.PREVIOUS_FINDING.shortcut})", Icons.Up, isEnabled = list.timeline.places.isNotEmpty()) {
                perform(Action.PREVIOUS_FINDING)
            }
            ToolButton("Next finding (${Action.NEXT_FINDING.shortcut})", Icons.Down, isEnabled = list.timeline.places.isNotEmpty()) {
                perform(Action.NEXT_FINDING)
            }
            ToolButton("Run the rules again", Icons.Reset) {
                findings.runAgain()
            }
        }
        Small("Rules: ${list.rulesFile?.let { "${it.fileName} in ${it.parent.fileName}" } ?: "built-in"}.")
        if (compared.drawn.size > 1) Small("Findings of the open log only, not of compared logs.")
        findings.state.refusal?.let { Box(Modifier.padding(horizontal = 12.dp, vertical = 4.dp)) { PointedText(it) } }
        ChangesList(changes, findings, compared, onGo)
        list.trouble?.let { Box(Modifier.padding(horizontal = 12.dp, vertical = 4.dp)) { PointedText(it) } }
        if (list.all.isNotEmpty()) {
            SearchField(query, "Search findings", Modifier.fillMaxWidth().padding(horizontal = 8.dp, vertical = 4.dp)) { query = it }
            HiddenLine(found.hidden) { query = "" }
        }
        Box(Modifier.weight(1f)) {
            LazyColumn(Modifier.fillMaxSize(), state) {
                val details = @Composable { finding: Finding ->
                    TodoMark(todo, taskOf(finding))
                    FindingDetails(findings, view, board, open, finding, times)
                    TodoButtons(todo, taskOf(finding))
                }
                items(found.incidents) { incident ->
                    IncidentLine(incident, times, selected, { goTo(it) }, details)
                }

                fun lines(listed: List<Finding>) = items(listed, key = { it }) { finding ->
                    val isSelected = finding === selected
                    ContextArea({ todoMenu(todo, taskOf(finding)) }) {
                        FindingLine(finding, times, isSelected, { goTo(finding) }) {
                            if (isSelected) details(finding) else TodoMark(todo, taskOf(finding))
                        }
                    }
                }
                lines(found.beside.outside)
                if (found.beside.within.isNotEmpty()) {
                    val isOpen = showsWithin || query.isNotEmpty() || selected in found.beside.within
                    val count = countText(found.beside.within.size, "more finding")
                    item { SkippedHead("$count, part of the incidents", isOpen) { showsWithin = !showsWithin } }
                    if (isOpen) lines(found.beside.within)
                }
                if (list.skipped.isNotEmpty()) {
                    item { SkippedHead(list.notLookedAt, showsSkipped) { showsSkipped = !showsSkipped } }
                    if (showsSkipped) item { LackingSignals(list.lacking, names, findings::assign) }
                    if (showsSkipped) items(list.skipped) { SkippedLine(it) }
                }
            }
            VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        }
    }
}

/** Says what a search hides, if anything, and offers to show it again. */
@Composable
private fun HiddenLine(text: String, onShow: () -> Unit) {
    if (text.isEmpty()) return
    Row(Modifier.fillMaxWidth().padding(start = 12.dp, end = 4.dp), verticalAlignment = Alignment.CenterVertically) {
        Text(text, Modifier.weight(1f), color = LocalPalette.current.muted, fontSize = 12.sp)
        ToolButton("Show the findings that the search hides", text = "Show them", onClick = onShow)
    }
}

/** Scrolls [list] until all of item [index] is visible; if it is higher than the list, its start. */
private suspend fun showWhole(list: LazyListState, index: Int) {
    val seen = list.layoutInfo.visibleItemsInfo
    if (seen.none { it.index == index }) list.scrollToItem(maxOf(0, index - seen.size / 2))
    val layout = list.layoutInfo
    val item = layout.visibleItemsInfo.firstOrNull { it.index == index }
    if (item == null || item.offset < layout.viewportStartOffset) {
        list.scrollToItem(index)
    } else if (item.offset + item.size > layout.viewportEndOffset) {
        list.scrollToItem(index, minOf(0, item.size - (layout.viewportEndOffset - layout.viewportStartOffset)))
    }
}

/** Returns what [found] counts of [list]; empty if it is not known whether something was found. */
private fun summaryOf(list: FindingList, found: SearchedFindings): String =
    found.counts.ifEmpty { if (list.trouble == null) SearchedFindings.NOTHING else "" }

@Composable
private fun Small(text: String) {
    Text(text, Modifier.padding(horizontal = 12.dp, vertical = 2.dp), color = LocalPalette.current.muted, fontSize = 12.sp)
}

/** A finding: its severity, time, rule and text; [details] are below. */
@Composable
internal fun FindingLine(
    finding: Finding,
    times: EventTimes,
    isSelected: Boolean,
    onClick: () -> Unit,
    details: @Composable () -> Unit = {},
) {
    val palette = LocalPalette.current
    Row(
        Modifier.inspectorLine("Finding, ${finding.severity.word}: ${finding.rule}", isSelected, gap = 5.dp, onClick),
        horizontalArrangement = Arrangement.spacedBy(8.dp),
    ) {
        Column(Modifier.width(62.dp)) {
            Text(
                finding.severity.word,
                Modifier
                    .fillMaxWidth()
                    .background(palette.findingSoft(finding.severity), RoundedCornerShape(4.dp))
                    .padding(horizontal = 4.dp),
                color = palette.findingColor(finding.severity),
                fontSize = 12.sp,
                textAlign = TextAlign.Center,
            )
            val since = times.sinceEnabled(finding.time)
            if (since != null) Time(since)
            Time(if (finding.time.isFinite()) times.logged(finding.time) else "whole log")
        }
        Column(Modifier.weight(1f)) {
            NameText(finding.rule, fontWeight = FontWeight.Medium, cut = NameCut.MIDDLE)
            Text(finding.text)
            details()
        }
    }
}

@Composable
private fun Time(text: String) {
    Text(
        text,
        Modifier.fillMaxWidth(),
        color = LocalPalette.current.muted,
        fontSize = 11.sp,
        textAlign = TextAlign.End,
        maxLines = 1,
        overflow = TextOverflow.Ellipsis,
    )
}

/** What could not be looked at, as [text]; a click shows or hides the rules that were skipped. */
@Composable
internal fun SkippedHead(text: String, isOpen: Boolean, onToggle: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .fillMaxWidth()
            .clickable(role = Role.Button, onClick = onToggle)
            .padding(start = 8.dp, end = 14.dp, top = 8.dp, bottom = 4.dp),
        Arrangement.spacedBy(4.dp),
        Alignment.CenterVertically,
    ) {
        Icon(if (isOpen) Icons.Down else Icons.Right, contentDescription = null, Modifier.size(14.dp), palette.muted)
        Text(text, color = palette.muted)
    }
}

/** A rule that was skipped for the log, and why. */
@Composable
internal fun SkippedLine(rule: SkippedRule) {
    val palette = LocalPalette.current
    Column(Modifier.fillMaxWidth().padding(start = 26.dp, end = 14.dp, top = 3.dp, bottom = 3.dp)) {
        NameText(rule.rule, cut = NameCut.MIDDLE)
        if (rule.isMistake) {
            PointedText(rule.message)
        } else {
            Text(rule.message, color = palette.muted, fontSize = 12.sp, maxLines = 8, overflow = TextOverflow.Ellipsis)
        }
    }
}

/** A mistake in a file of rules: a sentence and, if [text] has more lines, a place in the file with carets below it. */
@Composable
internal fun PointedText(text: String) {
    val palette = LocalPalette.current
    Column {
        Text(text.substringBefore('\n'), color = palette.error, maxLines = 8, overflow = TextOverflow.Ellipsis)
        val place = text.substringAfter('\n', "")
        if (place.isEmpty()) return@Column
        val scroll = rememberScrollState()
        LaunchedEffect(place, scroll.maxValue) { scroll.scrollTo((scroll.maxValue * placeOfCarets(place)).toInt()) }
        // A broken line would not be above its carets.
        Text(
            place.take(MAX_LETTERS),
            Modifier.horizontalScroll(scroll),
            fontFamily = FontFamily.Monospace,
            fontSize = 11.sp,
            lineHeight = 14.sp,
            softWrap = false,
        )
    }
}

/** Returns where the carets of the last line of [text] are in its longest line, 0 to 1. */
private fun placeOfCarets(text: String): Float =
    text.lastIndexOf(' ').minus(text.lastIndexOf('\n')).toFloat() / text.lines().maxOf { it.length }.coerceAtLeast(1)

private const val MAX_LETTERS = 2000
