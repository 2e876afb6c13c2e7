package badlog.window.topics

import androidx.compose.foundation.ContextMenuItem
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.draganddrop.dragAndDropSource
import androidx.compose.foundation.hoverable
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.interaction.collectIsHoveredAsState
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.Modifier
import androidx.compose.ui.draganddrop.DragAndDropTransferAction
import androidx.compose.ui.draganddrop.DragAndDropTransferData
import androidx.compose.ui.draganddrop.DragAndDropTransferable
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.input.pointer.PointerEventPass
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.PointerKeyboardModifiers
import androidx.compose.ui.input.pointer.isCtrlPressed
import androidx.compose.ui.input.pointer.isMetaPressed
import androidx.compose.ui.input.pointer.isShiftPressed
import androidx.compose.ui.input.pointer.onPointerEvent
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import badlog.viewer.state.GraphChange
import badlog.window.formula.FormulaStore
import badlog.window.formula.formulaMenu
import badlog.window.graph.quoted
import badlog.window.graph.signalTransfer
import badlog.window.log.AxisView
import badlog.window.log.DrawableTopic
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.log.valueText
import badlog.window.menu.ContextArea
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.Tip
import badlog.window.theme.ToolButton
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext

/**
 * A signal in the list of topics. A click draws it, a click with Ctrl or Shift selects it; a drag takes it to a graph, together with all
 * selected signals if it is one of them.
 *
 * @param place the number of its line's color in the first graph that draws it; null if none does.
 * @param showsValue whether its value fits beside its name.
 * @param toggle draws a signal, or removes it.
 */
@OptIn(ExperimentalComposeUiApi::class)
@Composable
internal fun SignalLine(
    board: GraphBoard,
    view: AxisView,
    formulas: FormulaStore,
    topics: TopicListing,
    open: OpenRecording,
    row: SignalRow,
    rows: List<TopicRow>,
    place: Int?,
    showsValue: Boolean,
    toggle: (DrawableTopic) -> Unit,
) {
    val palette = LocalPalette.current
    val signal = row.signal
    val isSelected = signal.name in topics.state.selected
    val isInTarget = targetOf(board, topics)?.lines?.contains(signal.name) == true
    var held by remember { mutableStateOf(PointerKeyboardModifiers()) }
    val interactions = remember { MutableInteractionSource() }
    val isHovered by interactions.collectIsHoveredAsState()
    ContextArea({ menuOf(board, formulas, topics, row) }) {
        Row(
            Modifier
                .fillMaxWidth()
                .height(26.dp)
                .background(
                    if (isSelected || isInTarget) {
                        palette.accentSoft
                    } else if (isHovered) {
                        palette.raised
                    } else {
                        Color.Transparent
                    },
                )
                .border(2.dp, if (signal.name == topics.state.marked) palette.accent else Color.Transparent, RoundedCornerShape(4.dp))
                .hoverable(interactions)
                .draggedAsSignals(palette.accent) { namesToTake(topics.state, signal.name) }
                .onPointerEvent(PointerEventType.Press, PointerEventPass.Initial) { held = it.keyboardModifiers }
                .clickable {
                    when {
                        held.isShiftPressed -> topics.change { selectedTo(signal.name, rows) }
                        held.isCtrlPressed || held.isMetaPressed -> topics.change { toggled(signal.name) }
                        else -> toggle(signal)
                    }
                }
                .semantics {
                    contentDescription = "Topic ${signal.name}"
                    selected = isSelected || isInTarget
                }
                .padding(start = indentOf(row.depth), end = 12.dp),
            horizontalArrangement = Arrangement.spacedBy(6.dp),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            KindMark(signal, open.isEvents(signal), place)
            val title = withMatches(signal.title, topics.state.query, palette)
            // A tooltip costs as much as the rest of the row, so only the row under the pointer has one.
            if (isHovered) {
                val explanation = signal.definition?.let { "Formula: $it" } ?: signal.name
                Tip(explanation, Modifier.weight(1f)) { Title(title, isDrawn = place != null, Modifier.fillMaxWidth()) }
            } else {
                Title(title, isDrawn = place != null, Modifier.weight(1f))
            }
            if (isHovered && !open.isEvents(signal)) {
                ToolButton("Add ${signal.name} to the last graph", Icons.Add) {
                    board.send(GraphChange.AddToLast(listOf(signal.name)))
                }
            } else if (showsValue) {
                SignalValue(view, open, signal)
            }
        }
    }
}

@Composable
private fun Title(text: AnnotatedString, isDrawn: Boolean, modifier: Modifier) {
    NameText(text, modifier, fontWeight = if (isDrawn) FontWeight.Medium else null)
}

/** Returns the names of the signals that a drag from [name] moves. */
internal fun namesToTake(list: TopicList, name: String): List<String> = if (name in list.selected) list.selected else listOf(name)

private fun menuOf(board: GraphBoard, formulas: FormulaStore, topics: TopicListing, row: SignalRow): List<ContextMenuItem> {
    val names = namesToTake(topics.state, row.signal.name)
    val these = if (names.size > 1) "these ${names.size}" else "this"
    return listOf(
        ContextMenuItem("New graph of $these") { board.send(GraphChange.Add(names)) },
        ContextMenuItem("Only a graph of $these") { board.send(GraphChange.ShowOnlyLines(names)) },
        ContextMenuItem("Add $these to the last graph") { board.send(GraphChange.AddToLast(names)) },
        ContextMenuItem(if (row.signal.name in topics.state.selected) "Unselect" else "Select") {
            topics.change { toggled(row.signal.name) }
        },
        ContextMenuItem("New formula with $these…") { formulas.write(names) },
    ) + board.state.graphs.map { graph ->
        ContextMenuItem("Add $these to ${quoted(board, graph)}") {
            board.send(GraphChange.AddLines(graph.id, names))
        }
    } + row.signal.definition?.let { formulaMenu(formulas, it) }.orEmpty()
}

/** The kind of the signal, or the color of its line if one is drawn at [place] of a graph. */
@Composable
internal fun KindMark(signal: DrawableTopic, isEvents: Boolean, place: Int?) {
    val palette = LocalPalette.current
    Box(Modifier.size(14.dp), Alignment.Center) {
        if (place != null) {
            Box(Modifier.size(10.dp).background(palette.line(place), RoundedCornerShape(2.dp)))
        } else {
            val icon = when {
                isEvents -> Icons.Flag
                signal.definition != null -> Icons.Formula
                signal.states != null -> Icons.Lanes
                else -> Icons.Wave
            }
            Icon(icon, contentDescription = null, Modifier.size(13.dp), palette.muted)
        }
    }
}

/** The value of [signal] at the cursor, or its number of events. A composable of its own because it changes while the pointer moves. */
@Composable
internal fun SignalValue(view: AxisView, open: OpenRecording, signal: DrawableTopic) {
    if (signal.isEmpty) {
        ValueText("no samples")
        return
    }
    if (open.isEvents(signal)) {
        val count = signal.topic.texts.size
        ValueText(if (count == 1) "1 event" else "$count events")
        return
    }
    val ready by produceState<DrawableTopic?>(null, signal) {
        // Samples are calculated on first use.
        withContext(Dispatchers.Default) { signal.series.isOrdered }
        value = signal
    }
    val text by remember(view) { derivedStateOf { ready?.let { valueText(it, view.cursor) }.orEmpty() } }
    ValueText(text)
}

@Composable
private fun ValueText(text: String) {
    Text(
        text,
        Modifier.widthIn(max = 104.dp),
        color = LocalPalette.current.muted,
        textAlign = TextAlign.End,
        maxLines = 1,
        overflow = TextOverflow.Ellipsis,
    )
}

/** Makes an element draggable: it carries the signals that [names] returns when the drag begins. */
@OptIn(ExperimentalComposeUiApi::class)
internal fun Modifier.draggedAsSignals(color: Color, names: () -> List<String>): Modifier = dragAndDropSource(
    // Only a color: a picture would be recorded for every row.
    drawDragDecoration = { drawRoundRect(color, alpha = 0.4f) },
) {
    DragAndDropTransferData(
        transferable = DragAndDropTransferable(signalTransfer(names())),
        supportedActions = listOf(DragAndDropTransferAction.Copy),
    )
}
