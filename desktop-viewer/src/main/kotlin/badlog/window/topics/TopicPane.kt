package badlog.window.topics

import androidx.compose.foundation.ContextMenuItem
import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.selection.toggleable
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.text.withStyle
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import badlog.viewer.input.KeyAction
import badlog.viewer.shown.search.Query
import badlog.viewer.state.GraphChange
import badlog.window.compare.ComparedRecordings
import badlog.window.formula.FormulaStore
import badlog.window.formula.UnmadeFormulas
import badlog.window.graph.plot.MAX_LINES
import badlog.window.graph.quoted
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.DrawableTopic
import badlog.window.log.FilteredEvents
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.menu.ClosesByEscape
import badlog.window.menu.ContextArea
import badlog.window.sidebar.WindowPanels
import badlog.window.theme.Icons
import badlog.window.theme.KeepInSight
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.Palette
import badlog.window.theme.SearchField
import badlog.window.theme.ToolButton
import badlog.window.theme.rememberAskedFocus
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import java.nio.file.Path

/**
 * The topics of the open recording by folder.
 *
 * @param topicsWithFindings returns the names of the topics that a finding is about.
 */
@Composable
internal fun TopicPane(
    current: CurrentRecording,
    compared: ComparedRecordings,
    board: GraphBoard,
    view: AxisView,
    events: FilteredEvents,
    formulas: FormulaStore,
    topics: TopicListing,
    panels: WindowPanels,
    modifier: Modifier = Modifier,
    topicsWithFindings: () -> Set<String> = { emptySet() },
) {
    Column(modifier.background(LocalPalette.current.surface)) {
        val list = topics.state
        val open = current.recording
        val found = topicsWithFindings()
        val shown by produceState<ShownRows?>(null, open, list.query, list.folded, found) {
            value = open?.let { withContext(Dispatchers.Default) { ShownRows(it.file, list.query, it.rowsOf(list, found)) } }
        }
        // The rows of another log would lose this log's scroll position.
        val ofThis = { shown?.takeIf { it.file == open?.file } }
        val rows = ofThis()?.rows
        // A key may come before the rows for the typed text are shown.
        val rowsOfKeys = { ofThis()?.takeIf { it.query == topics.state.query }?.rows ?: open?.rowsOf(topics.state, found).orEmpty() }
        val toggle = { signal: DrawableTopic -> toggleIn(current, board, events, topics, panels, signal) }
        fun draw(name: String) {
            val offered = rowsOfKeys().firstOrNull { it is GraphRow && it.name == name } as GraphRow?
            if (offered != null) return board.send(GraphChange.Toggle(offered.graph))
            open?.signal(name)?.let(toggle)
        }
        val focus = rememberAskedFocus(list.isSearchAsked) { topics.change { copy(isSearchAsked = false) } }
        val keyed = Modifier.focusRequester(focus).onPreviewKeyEvent { handlesKeys(it, topics, rowsOfKeys, ::draw) }
        Row(Modifier.fillMaxWidth().padding(start = 8.dp, end = 4.dp), verticalAlignment = Alignment.CenterVertically) {
            SearchField(list.query, "Search topics", keyed.weight(1f).padding(vertical = 8.dp)) {
                topics.change { searching(it) }
            }
            ToolButton("New formula… (${KeyAction.NEW_FORMULA.shortcut})", Icons.Formula, isEnabled = open != null) { formulas.write() }
        }
        TargetLine(board, topics)
        when {
            open == null -> Hint("Open a log to see its topics.")
            open.signals.isEmpty() -> Hint("This log has no topics with samples.")
            else -> Rows(compared, board, view, formulas, topics, open, rows, toggle, Modifier.weight(1f))
        }
        if (open != null) UnmadeFormulas(formulas, open)
        if (list.selected.isNotEmpty()) SelectedTopics(current, board, topics)
    }
}

/** The rows of the log in [file], searched for [query]. */
private class ShownRows(val file: Path, val query: String, val rows: List<TopicRow>)

private fun OpenRecording.rowsOf(list: TopicList, found: Set<String>) = topicRows(
    signals,
    list.query,
    list.folded,
    empty,
    found,
    // Paths and XY plots are graphs of their own.
    if (list.target == null) paths.poses else emptyList(),
    offersXy = list.target == null,
)

/** Handles keys in the search field. The arrow keys move through the list, and Enter draws the focused topic, or the first one. */
private fun handlesKeys(event: KeyEvent, topics: TopicListing, rows: () -> List<TopicRow>, draw: (String) -> Unit): Boolean {
    if (event.type != KeyEventType.KeyDown) return false
    when (event.key) {
        Key.DirectionDown -> topics.change { marking(1, rows()) }
        Key.DirectionUp -> topics.change { marking(-1, rows()) }
        Key.Enter, Key.NumPadEnter -> (topics.state.marked ?: rows().firstNotNullOfOrNull { it.name })?.let(draw)
        else -> return false
    }
    return true
}

@Composable
private fun Hint(text: String) {
    Text(text, Modifier.padding(horizontal = 12.dp, vertical = 8.dp), color = LocalPalette.current.muted)
}

@Composable
private fun Rows(
    compared: ComparedRecordings,
    board: GraphBoard,
    view: AxisView,
    formulas: FormulaStore,
    topics: TopicListing,
    open: OpenRecording,
    rows: List<TopicRow>?,
    toggle: (DrawableTopic) -> Unit,
    modifier: Modifier,
) {
    val query = topics.state.query
    val listed = rows ?: return
    if (listed.isEmpty()) {
        Hint("No topic matches “$query”.")
        return
    }
    val graphs = board.state
    // As in graphs: with several recordings, each line has a color per recording.
    val recordings = compared.drawn.size
    val places = remember(graphs, recordings) { graphs.placesOfLines().mapValues { it.value * recordings } }
    val state = topics.list
    KeepInSight(state, topics.state.marked, listed.indexOfFirst { it.name != null && it.name == topics.state.marked })
    BoxWithConstraints(modifier.fillMaxSize()) {
        val showsValues = maxWidth >= ROOMY
        LazyColumn(Modifier.fillMaxSize(), state) {
            items(listed, key = { it.key }, contentType = { it is FolderRow }) { row ->
                when (row) {
                    is FolderRow -> ContextArea({ folderMenu(board, open, row.path) }) {
                        FolderLine(row, query) {
                            topics.change { toggledFolder(row.path) }
                        }
                    }

                    is GraphRow -> {
                        val isMarked = row.name == topics.state.marked
                        GraphLine(row, query, graphs.has(row.graph), isMarked) { board.send(GraphChange.Toggle(row.graph)) }
                    }

                    is SignalRow -> {
                        val place = places[row.signal.name]
                        SignalLine(board, view, formulas, topics, open, row, listed, place, showsValues, toggle)
                    }
                }
            }
        }
        VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
    }
}

/** Returns the menu for drawing the topics in folder [path] of [open]. */
private fun folderMenu(board: GraphBoard, open: OpenRecording, path: String): List<ContextMenuItem> {
    val names = topicsIn(path, open.signals.filter { !open.isEvents(it) }).map { it.name }
    if (names.isEmpty()) return emptyList()
    val few = names.take(MAX_LINES)
    val these = if (few.size < names.size) "the first ${few.size} topics of this folder" else "this folder"
    return listOf(
        ContextMenuItem("New graph of $these") { board.send(GraphChange.Add(few)) },
        ContextMenuItem("Only a graph of $these") { board.send(GraphChange.ShowOnlyLines(few)) },
        ContextMenuItem("Separate graphs of $these") { board.send(GraphChange.AddEach(few)) },
    )
}

/** A folder of the list of topics. */
@Composable
internal fun FolderLine(row: FolderRow, query: String, onToggle: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .fillMaxWidth()
            .clickable(onClick = onToggle)
            .semantics { contentDescription = "Folder ${row.path}" }
            .padding(start = indentOf(row.depth), end = 14.dp, top = 4.dp, bottom = 4.dp),
        horizontalArrangement = Arrangement.spacedBy(4.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Icon(if (row.isOpen) Icons.Down else Icons.Right, contentDescription = null, Modifier.size(14.dp), palette.muted)
        NameText(
            withMatches(row.title, query, palette),
            Modifier.weight(1f),
            fontWeight = FontWeight.SemiBold,
        )
        Text(row.count.toString(), color = palette.muted, maxLines = 1)
    }
}

/** A path or XY plot in the list of topics. */
@Composable
private fun GraphLine(row: GraphRow, query: String, isDrawn: Boolean, isMarked: Boolean, onToggle: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .fillMaxWidth()
            .border(2.dp, if (isMarked) palette.accent else Color.Transparent, RoundedCornerShape(4.dp))
            .toggleable(isDrawn, role = Role.Checkbox) { onToggle() }
            .semantics { contentDescription = row.graph.title }
            .padding(start = indentOf(row.depth), end = 14.dp, top = 4.dp, bottom = 4.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        val color = if (isDrawn) palette.accent else palette.text
        NameText(withMatches(row.graph.title, query, palette), color = color)
    }
}

/** Returns the indentation at [depth] folders; it is limited, so that there is room for names. */
internal fun indentOf(depth: Int): Dp = (8 + 12 * minOf(depth, MAX_DEPTH)).dp

/** Returns [text] with the matches of the words of [query] highlighted. */
internal fun withMatches(text: String, query: String, palette: Palette): AnnotatedString = buildAnnotatedString {
    val isFound = BooleanArray(text.length)
    for (word in Query(query).words) {
        var at = text.indexOf(word, ignoreCase = true)
        while (at >= 0) {
            isFound.fill(true, at, at + word.length)
            at = text.indexOf(word, at + word.length, ignoreCase = true)
        }
    }
    text.forEachIndexed { index, char ->
        if (isFound[index]) withStyle(SpanStyle(palette.accent, background = palette.accentSoft)) { append(char) } else append(char)
    }
}

/** In a narrower pane, a value would leave no room for the name. */
private val ROOMY = 190.dp

private const val MAX_DEPTH = 6

/**
 * The line above the list of topics that names the graph to which a click adds a topic. It has a button that ends this, and is empty if
 * each topic gets its own graph.
 */
@Composable
internal fun TargetLine(board: GraphBoard, topics: TopicListing) {
    val wanted = topics.state.target ?: return
    val target = targetOf(board, topics)
    // Another graph may get the same id later.
    LaunchedEffect(wanted, target == null) { if (target == null) topics.change { adding(null) } }
    if (target == null) return
    ClosesByEscape(isOpen = true) { topics.change { adding(null) } }
    Row(
        Modifier.fillMaxWidth().background(LocalPalette.current.accentSoft).padding(start = 12.dp, end = 4.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Text("Click topics to add to ${quoted(board, target)}", Modifier.weight(1f), maxLines = 3, overflow = TextOverflow.Ellipsis)
        ToolButton("Stop adding topics (Esc)", text = "Done") { topics.change { adding(null) } }
    }
}

/** The actions for the selected topics. */
@Composable
internal fun SelectedTopics(current: CurrentRecording, board: GraphBoard, topics: TopicListing) {
    val selected = topics.state.selected
    val draw = { change: (List<String>) -> Unit ->
        change(selected.filter { name -> current.recording?.run { signal(name)?.let { !isEvents(it) } } == true })
        topics.change { copy(selected = emptyList()) }
    }
    HorizontalDivider()
    Column(Modifier.fillMaxWidth().background(LocalPalette.current.accentSoft).padding(start = 8.dp, end = 4.dp, bottom = 4.dp)) {
        Row(verticalAlignment = Alignment.CenterVertically) {
            Text("${selected.size} selected", Modifier.weight(1f), maxLines = 1)
            ToolButton("Clear the selection of topics", Icons.Close) { topics.change { copy(selected = emptyList()) } }
        }
        FlowRow {
            ToolButton("New graph of the selected topics", text = "New graph") {
                draw { board.send(GraphChange.Add(it)) }
            }
            ToolButton("Show only these topics", text = "Only these") {
                draw { names -> board.send(GraphChange.ShowOnlyLines(names)) }
            }
            ToolButton("A graph for each selected topic", text = "Separate graphs") {
                draw { names -> board.send(GraphChange.AddEach(names)) }
            }
            ToolButton("Add these to the last graph", text = "Add to last graph") {
                draw { board.send(GraphChange.AddToLast(it)) }
            }
        }
    }
}
