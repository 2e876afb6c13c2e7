package badlog.viewer.formula

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.app.Viewer
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton
import badlog.viewer.theme.sheet

/** Lets a person write the formula of [sheet] over the open recording; lies above the window. */
@Composable
internal fun FormulaDialog(viewer: Viewer, sheet: FormulaSheet, modifier: Modifier) {
    val open = viewer.open ?: return
    val palette = LocalPalette.current
    // A log that grows keeps its topics.
    val writer = remember(sheet, open.file) { FormulaWriter(sheet.start, vocabularyFor(open, sheet.before)) }
    val close = { viewer.formulaSheet = null }
    val keep = { keepFormula(viewer, sheet, writer) }
    Column(
        modifier
            .sheet("Formula sheet", widest = 640.dp)
            .onPreviewKeyEvent { hears(it, writer, keep, close) }
            .verticalScroll(rememberScrollState())
            .padding(start = 20.dp, end = 12.dp, top = 8.dp, bottom = 12.dp),
        Arrangement.spacedBy(6.dp),
    ) {
        Row(verticalAlignment = Alignment.CenterVertically) {
            val title = if (sheet.before == null) "New formula" else "Change the formula"
            Text(title, Modifier.weight(1f), fontSize = 16.sp, fontWeight = FontWeight.SemiBold)
            ToolButton("Close the formula sheet", Icons.Close, onClick = close)
        }
        FormulaField(writer)
        val error = writer.error
        if (error != null) {
            Text(error.message, color = palette.error)
        } else {
            Text(writer.topic?.let { "Makes the topic “${it.name}”." } ?: HOW, color = palette.muted)
        }
        SuggestedNames(writer)
        FormulaHelp()
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp, Alignment.End)) {
            sheet.before?.let { before ->
                ToolButton("Remove this formula", text = "Remove", color = palette.error) {
                    removeFormula(viewer, before)
                    close()
                }
            }
            val isTopic = writer.topic != null
            ToolButton("Keep the formula (Enter)", text = "OK", isOn = isTopic, isEnabled = isTopic, onClick = keep)
        }
    }
}

/** Keeps what is written, where it is a formula, and closes the sheet. */
private fun keepFormula(viewer: Viewer, sheet: FormulaSheet, writer: FormulaWriter) {
    val topic = writer.topic ?: return
    val definition = writer.field.text.trim()
    if (sheet.before == null) addFormula(viewer, definition, topic.name) else changeFormula(viewer, sheet.before, definition, topic.name)
    viewer.formulaSheet = null
}

private fun hears(event: KeyEvent, writer: FormulaWriter, keep: () -> Unit, close: () -> Unit): Boolean {
    if (event.type != KeyEventType.KeyDown) return false
    val hasNames = writer.suggestions.names.isNotEmpty()
    when (event.key) {
        Key.Escape -> close()
        Key.Enter, Key.NumPadEnter -> if (writer.marked >= 0) writer.take(writer.marked) else keep()
        Key.Tab -> if (hasNames) writer.take(maxOf(0, writer.marked)) else return false
        Key.DirectionDown -> if (hasNames) writer.mark(1) else return false
        Key.DirectionUp -> if (hasNames) writer.mark(-1) else return false
        else -> return false
    }
    return true
}

private const val HOW = "A name, a unit in brackets if it has one, =, and how it is calculated; / in the name makes folders."
