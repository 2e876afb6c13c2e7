package badlog.window.sidebar

import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.LocalTextStyle
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import badlog.catalog.folder.LogEntry
import badlog.core.analysis.EventLog
import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.evidenceOffers
import badlog.viewer.choices.note.NoteDraft
import badlog.viewer.draw.swerve.DrivePicture
import badlog.viewer.panel.Button
import badlog.viewer.panel.CursorLine
import badlog.viewer.panel.ListedTasks
import badlog.viewer.panel.LogTimes
import badlog.viewer.panel.Part
import badlog.viewer.panel.PartIcon
import badlog.viewer.panel.cursorPanel
import badlog.viewer.panel.eventsPanel
import badlog.viewer.panel.finding.FindingDetails
import badlog.viewer.panel.finding.FindingsShown
import badlog.viewer.panel.finding.findingsPanel
import badlog.viewer.panel.metadataPanel
import badlog.viewer.panel.modulesPanel
import badlog.viewer.panel.notesPanel
import badlog.viewer.shown.comparison.shortLabel
import badlog.viewer.shown.cursor.CursorValues
import badlog.viewer.shown.folder.Changes
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.swerve.SwerveDrive
import badlog.viewer.state.Action
import badlog.viewer.state.GraphChange
import badlog.viewer.text.cursorText
import badlog.viewer.text.placeText
import badlog.viewer.text.unitText
import badlog.viewer.text.withUnit
import badlog.window.findings.CurrentFindings
import badlog.window.log.AxisView
import badlog.window.log.DrawableTopic
import badlog.window.log.FilteredEvents
import badlog.window.log.GraphBoard
import badlog.window.log.LogNotes
import badlog.window.log.OpenRecording
import badlog.window.log.isFoundBy
import badlog.window.panel.PanelView
import badlog.window.theme.LocalPalette
import badlog.window.theme.SearchField
import badlog.window.theme.ToolButton
import badlog.window.theme.fieldFrame
import badlog.window.todo.FolderTodo
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.withContext

/** The values that were known when [open] began, see [metadataPanel]. */
@Composable
internal fun MetadataPanel(view: AxisView, open: OpenRecording, modifier: Modifier) {
    var query by remember { mutableStateOf("") }
    val parts = remember(open, query, view.unfolded) { metadataPanel(open.view.folders, query, view.unfolded) }
    Column(modifier) {
        SearchField(query, "Search metadata", Modifier.fillMaxWidth().padding(8.dp)) { query = it }
        PanelView(parts, goal = null, view::send, Modifier.weight(1f))
    }
}

/** All events of [open] in the order of x, see [eventsPanel]. */
@Composable
internal fun EventsPanel(view: AxisView, events: FilteredEvents, open: OpenRecording, send: (Action) -> Unit, modifier: Modifier) {
    val isReady by produceState(false, open) {
        // Both are calculated on first use.
        withContext(Dispatchers.Default) {
            open.events
            open.enabled
        }
        value = true
    }
    if (!isReady) return
    val all = open.events.size
    val found = events.matching
    val nearest by remember(view, found) { derivedStateOf { view.cursor?.let(found::nearest) ?: -1 } }
    val parts = remember(open, found, nearest) { eventsPanel(found, all, open.times, hasTopics = open.eventLogs.size > 1, nearest) }
    Column(modifier) {
        if (all > 0) {
            SearchField(events.state.text, "Search events", Modifier.fillMaxWidth().padding(8.dp)) { events.change { copy(text = it) } }
            if (open.eventLogs.size > 1) EventTopics(events, open.eventLogs)
        }
        PanelView(parts, goal = nearest, send, Modifier.weight(1f))
    }
}

/** Selects the topics of the listed events. */
@Composable
private fun EventTopics(events: FilteredEvents, logs: List<EventLog>) {
    val chosen = events.state.topicsOf(logs)
    FlowRow(Modifier.padding(horizontal = 8.dp).heightIn(max = 120.dp).verticalScroll(rememberScrollState())) {
        ToolButton("Events of all topics", text = "All", isOn = chosen.isEmpty()) {
            events.change { copy(topics = emptySet()) }
        }
        for (log in logs.take(MAX_TOPICS)) {
            ToolButton(
                "Events of ${log.name}",
                text = shortLabel(log.title, MAX_TITLE_LENGTH),
                isOn = log.name in chosen,
                modifier = Modifier.widthIn(max = 180.dp),
            ) { events.change { toggled(log.name) } }
        }
    }
}

/** The largest number of topics to select from; for others, use the search. */
private const val MAX_TOPICS = 40

/** The number of letters that fit into a button, which would cut off the end of a longer text. */
private const val MAX_TITLE_LENGTH = 24

/**
 * The findings in [open], see [findingsPanel].
 *
 * @param changes the differences between the log and earlier ones.
 * @param isComparing whether other logs are drawn.
 */
@Composable
internal fun FindingsPanel(
    findings: CurrentFindings,
    todo: FolderTodo,
    view: AxisView,
    board: GraphBoard,
    open: OpenRecording,
    changes: Changes<LogEntry>,
    isComparing: Boolean,
    send: (Action) -> Unit,
    modifier: Modifier,
) {
    val known = findings.state
    val names = remember(open) { open.view.recording.topics.filter { it.size > 0 }.map { it.name }.sorted() }
    val evidence = board.evidence
    val details =
        remember(open, evidence) { FindingDetails(evidence.graphs.isNotEmpty(), evidenceOffers(open.view, open.vocabulary, evidence)) }
    val list = todo.state.list.takeIf { todo.state.folder != null }
    val parts = remember(open, known.list, view.findings, view.visited, changes, details, list, isComparing, view.unfolded) {
        val shown = FindingsShown(
            known.list,
            isRunning = known.list == null,
            view.findings,
            view.visited,
            open.times,
            changes.differences,
            names,
            todo = list?.let { ListedTasks(it, open.file.fileName.toString(), todo.author) },
            details = details,
            isComparing = isComparing,
            unfolded = view.unfolded,
        )
        findingsPanel(shown)
    }
    PanelView(parts, listOf(view.visited, view.findings.query), send, modifier)
}

/** The modules of a swerve drive, see [modulesPanel]: at the cursor, and their errors in the visible range. */
@Composable
internal fun ModulesPanel(view: AxisView, open: OpenRecording, send: (Action) -> Unit, modifier: Modifier) {
    val drive = open.drive ?: return PanelHint(SwerveDrive.NONE)
    // Another log must not show the numbers of the previous one; a growing log may show slightly older numbers.
    val parts by key(open.file) {
        produceState<List<Part>?>(null, open) {
            val picture = withContext(Dispatchers.Default) { DrivePicture(drive, drive.errors).also { drive.fastest } }
            snapshotFlow { view.viewport.visible }.conflate().map { visible ->
                withContext(Dispatchers.Default) { partsOf(drive, picture, visible, view, open) }
            }.collect { value = it }
        }
    }
    parts?.let { PanelView(it, goal = null, send, modifier) }
}

private fun partsOf(drive: SwerveDrive, picture: DrivePicture, visible: Span, view: AxisView, open: OpenRecording): List<Part> {
    val axis = open.view.xAxis
    fun placeOf(x: Double) = withUnit(placeText(x, axis, visible.width), axis.unit)
    return modulesPanel(drive, drive.errors?.within(visible).orEmpty(), ::placeOf, picture) { pen, width, colors ->
        // Reads the place while drawing, so that moving a cursor only redraws the picture.
        draw(pen, width, view.viewport.visible, view.cursors, colors)
    }
}

/** The values at the cursor of the graphs' topics, or of those that a search finds, see [cursorPanel]. */
@Composable
internal fun CursorPanel(board: GraphBoard, findings: CurrentFindings, view: AxisView, open: OpenRecording, modifier: Modifier) {
    var query by remember { mutableStateOf("") }
    val parts by produceState(emptyList<Part>(), open) {
        var asked: Pair<List<DrawableTopic>, Board>? = null
        var lines = emptyList<CursorLine>()
        var values = CursorValues(emptyList(), open.view.xAxis)
        snapshotFlow {
            CursorQuestion(query, board.state, findings.state.topics, view.cursor, view.viewport.visible.width)
        }.conflate().map { (query, graphs, found, x, width) ->
            withContext(Dispatchers.Default) {
                val signals = cursorSignals(open, graphs, query, found)
                if (signals to graphs != asked) {
                    lines = signals.map { CursorLine(it.name, it.line, pinOf(it.name, graphs)) }
                    values = CursorValues(lines.map { it.line }, open.view.xAxis)
                }
                asked = signals to graphs
                cursorPanel(lines, values, x, x?.let { cursorText(it, open.view.xAxis, width, open.clocks.textAt(it)) }.orEmpty())
            }
        }.collect { value = it }
    }
    Column(modifier) {
        SearchField(query, "Search topics", Modifier.fillMaxWidth().padding(8.dp)) { query = it }
        PanelView(parts, goal = null, { action ->
            val drawn = (action as? GraphChange.Add)?.let { change -> board.state.graphs.find { it.lines.containsAll(change.lines) } }
            if (drawn != null) board.goTo(drawn.id) else view.send(action)
        }, Modifier.weight(1f))
    }
}

private data class CursorQuestion(val query: String, val graphs: Board, val found: Set<String>, val x: Double?, val width: Double)

/** Returns the button that draws [name], or goes to its graph on [board]. */
private fun pinOf(name: String, board: Board): Button {
    val isDrawn = board.graphs.any { name in it.lines }
    return Button(if (isDrawn) "Go to the graph of $name" else "Draw $name", GraphChange.Add(listOf(name)), PartIcon.PIN, isOn = isDrawn)
}

/**
 * Returns the topics with a name or unit that [query] matches. Without a query, it returns the topics in the graphs of [board].
 *
 * @param found the names of the topics that a finding is about.
 */
internal fun cursorSignals(open: OpenRecording, board: Board, query: String, found: Set<String> = emptySet()): List<DrawableTopic> {
    val wanted = Query(query)
    if (wanted.isEmpty) return board.graphs.flatMap { it.lines }.distinct().mapNotNull(open::signal)
    return open.signals.filter { (it.hasFigures || it.states != null) && it.isFoundBy(wanted, found, "${it.name} ${unitText(it.unit)}") }
}

/** The notes of [open], see [notesPanel], and the field for writing one. */
@Composable
internal fun NotesPanel(notes: LogNotes, todo: FolderTodo, open: OpenRecording, send: (Action) -> Unit, modifier: Modifier) {
    Column(modifier) {
        val draft = notes.draft
        if (draft != null) NoteField(notes, draft, open.times)
        val list = todo.state.list.takeIf { todo.state.folder != null }
        val parts = remember(open, notes.all, list, draft == null) {
            val file = open.file.fileName.toString()
            notesPanel(notes.all, open.times, file, list?.let { ListedTasks(it, file, todo.author) }, isWriting = draft != null)
        }
        PanelView(parts, goal = null, send, Modifier.weight(1f))
    }
}

@Composable
private fun NoteField(notes: LogNotes, draft: NoteDraft, times: LogTimes) {
    val palette = LocalPalette.current
    val focus = remember { FocusRequester() }
    val interactions = remember { MutableInteractionSource() }
    LaunchedEffect(draft.x, draft.replaced) { focus.requestFocus() }
    Column(Modifier.fillMaxWidth().padding(8.dp), Arrangement.spacedBy(4.dp)) {
        Text("Note at ${times.logged(draft.x)}", color = palette.muted)
        BasicTextField(
            draft.text,
            notes::type,
            Modifier
                .fillMaxWidth()
                .fieldFrame(interactions, horizontal = 8.dp, vertical = 6.dp)
                .focusRequester(focus)
                .onPreviewKeyEvent { handles(it, notes) }
                .semantics { contentDescription = "Text of the note" },
            textStyle = LocalTextStyle.current.copy(color = palette.text),
            maxLines = 6,
            interactionSource = interactions,
            cursorBrush = SolidColor(palette.accent),
        )
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp, Alignment.End)) {
            ToolButton("Cancel the note (Escape)", text = "Cancel", onClick = notes::cancel)
            ToolButton("Save the note (Enter)", text = "OK", isOn = true, isEnabled = draft.text.isNotBlank(), onClick = notes::keep)
        }
    }
}

/** Handles keys: Enter saves, Escape cancels; Shift+Enter is a new line. */
private fun handles(event: KeyEvent, notes: LogNotes): Boolean {
    if (event.type != KeyEventType.KeyDown) return false
    when {
        event.key == Key.Escape -> notes.cancel()
        (event.key == Key.Enter || event.key == Key.NumPadEnter) && !event.isShiftPressed -> notes.keep()
        else -> return false
    }
    return true
}
