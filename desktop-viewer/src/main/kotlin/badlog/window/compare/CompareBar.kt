package badlog.window.compare

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.LocalTextStyle
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import badlog.viewer.choices.comparison.Alignment
import badlog.viewer.choices.comparison.OFFSET_STEPS
import badlog.viewer.choices.comparison.OffsetStep
import badlog.viewer.choices.comparison.offsetOf
import badlog.viewer.choices.comparison.offsetText
import badlog.viewer.shown.comparison.shortLabel
import badlog.window.log.CurrentRecording
import badlog.window.log.OpenRecording
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.Tip
import badlog.window.theme.ToolButton
import badlog.window.theme.fieldFrame
import androidx.compose.ui.Alignment as Place

/** The logs compared with the open one, and their alignment; empty if there are none. */
@Composable
internal fun CompareBar(current: CurrentRecording, compared: ComparedRecordings) {
    val open = current.recording ?: return
    val comparison = compared.state
    if (comparison.checked.all { it == open.file }) return
    val palette = LocalPalette.current
    Column(Modifier.fillMaxWidth().background(palette.surface)) {
        FlowRow(
            Modifier.fillMaxWidth().padding(start = 12.dp, end = 4.dp, top = 2.dp, bottom = 2.dp),
            itemVerticalAlignment = Place.CenterVertically,
        ) {
            Text("Align at", Modifier.padding(end = 6.dp), color = palette.muted)
            for (alignment in Alignment.entries) {
                ToolButton(alignment.hint, text = alignment.title, isOn = alignment == comparison.offsets.alignment) {
                    compared.change { alignedBy(alignment, open) }
                }
            }
            ToolButton("Stop comparing", Icons.Close, text = "Stop comparing") { compared.clear() }
        }
        FlowRow(
            Modifier
                .fillMaxWidth()
                .heightIn(max = 140.dp)
                .verticalScroll(rememberScrollState())
                .padding(start = 8.dp, end = 8.dp, bottom = 6.dp),
            Arrangement.spacedBy(6.dp),
            Arrangement.spacedBy(4.dp),
        ) {
            compared.drawn.forEachIndexed { index, drawn -> ComparedChip(compared, open, drawn, palette.colorOf(index)) }
            for (file in comparison.checked) {
                if (file != open.file && file !in comparison.loaded) {
                    Row(Modifier.padding(horizontal = 8.dp, vertical = 6.dp)) {
                        NameText("Reading ${file.fileName}…", color = palette.muted, cut = NameCut.MIDDLE)
                    }
                }
            }
        }
        HorizontalDivider()
    }
}

/** One of the compared recordings: its color, name and offset. */
@Composable
internal fun ComparedChip(compared: ComparedRecordings, open: OpenRecording, drawn: DrawnRecording, color: Color) {
    val palette = LocalPalette.current
    val recording = drawn.recording
    val isOpen = recording.file == open.file
    Row(
        Modifier.border(1.dp, palette.border, RoundedCornerShape(6.dp)).padding(start = 8.dp, end = 2.dp, top = 1.dp, bottom = 1.dp),
        Arrangement.spacedBy(2.dp),
        Place.CenterVertically,
    ) {
        Box(Modifier.size(10.dp).background(color, RoundedCornerShape(2.dp)))
        Tip("${recording.label} (${recording.file.fileName})", Modifier.weight(1f, fill = false).padding(start = 6.dp, end = 6.dp)) {
            NameText(shortLabel(drawn.name, letters = 28), Modifier.padding(vertical = 5.dp), cut = NameCut.MIDDLE)
        }
        if (isOpen) {
            Text("open", Modifier.padding(end = 8.dp), color = palette.muted)
        } else {
            val moveTo = { offset: Double -> compared.change { movedTo(recording.file, offset, open) } }
            val (back, on) = OFFSET_STEPS.partition { it.by < 0 }
            val nudge = @Composable { step: OffsetStep ->
                ToolButton(step.hintFor(drawn.name), text = step.label) { moveTo(drawn.offset + step.by) }
            }
            for (step in back) nudge(step)
            OffsetField(drawn.name, drawn.offset, moveTo)
            for (step in on) nudge(step)
            ToolButton("Stop comparing with ${drawn.name}", Icons.Close) { compared.remove(recording.file) }
        }
    }
}

/** A field with the offset of the recording called [label]. After typing a number, Enter or leaving the field moves the recording. */
@Composable
internal fun OffsetField(label: String, offset: Double, onMove: (Double) -> Unit) {
    val palette = LocalPalette.current
    val interactions = remember { MutableInteractionSource() }
    // The text being typed; null while nothing is being typed.
    var draft by remember(offset) { mutableStateOf<String?>(null) }
    val isMistyped = draft?.let { offsetOf(it) == null } == true
    val finish = {
        draft?.let(::offsetOf)?.let(onMove)
        draft = null
    }
    BasicTextField(
        draft ?: offsetText(offset),
        { draft = it },
        Modifier
            .width(88.dp)
            .fieldFrame(interactions, horizontal = 5.dp, vertical = 3.dp, isWrong = isMistyped)
            .onFocusChanged { if (!it.isFocused) finish() }
            .onKeyEvent { event ->
                val isEnter = event.type == KeyEventType.KeyDown && (event.key == Key.Enter || event.key == Key.NumPadEnter)
                if (isEnter) finish()
                isEnter
            }
            .semantics { contentDescription = "Offset of $label" },
        textStyle = LocalTextStyle.current.copy(textAlign = TextAlign.End),
        singleLine = true,
        interactionSource = interactions,
        cursorBrush = SolidColor(palette.accent),
    )
}
