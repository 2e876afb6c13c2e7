package badlog.window.formula

import androidx.compose.foundation.ContextMenuItem
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Icon
import androidx.compose.material3.LocalTextStyle
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.input.OffsetMapping
import androidx.compose.ui.text.input.TransformedText
import androidx.compose.ui.text.style.TextDecoration
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.expression.ExpressionError
import badlog.viewer.choices.formula.Formula
import badlog.viewer.choices.formula.reasonToKeepName
import badlog.window.log.OpenRecording
import badlog.window.menu.ContextArea
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.Palette
import badlog.window.theme.ToolButton
import badlog.window.theme.fieldFrame
import badlog.window.theme.sheet

/** The dialog for the formula of [sheet] for the open recording; shown above the window. */
@Composable
internal fun FormulaDialog(formulas: FormulaStore, sheet: FormulaSheet, open: OpenRecording, modifier: Modifier) {
    val palette = LocalPalette.current
    // A log that grows keeps its topics.
    val writer = remember(sheet, open.file) { FormulaWriter(sheet.start, vocabularyFor(open, sheet.before)) }
    val close = formulas::closeSheet

    fun reason() = writer.remark?.text ?: sheet.before?.let { open.formulas.reasonToKeepName(it, writer.field.text) }

    fun isReady() = reason() == null && writer.topic != null
    // Evaluated when the key is pressed, which may be before the text of the previous key is drawn.
    val keep = { if (isReady()) keepFormula(formulas, sheet, writer) }
    Column(
        modifier
            .sheet("Formula sheet", widest = 640.dp)
            .onPreviewKeyEvent { handles(it, writer, keep, close) }
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
        val reason = reason()
        if (reason != null) {
            Text(reason, color = if (writer.remark?.isError == false) palette.muted else palette.error)
        } else {
            Text(writer.topic?.let { "Makes the topic “${it.name}”." } ?: HOW, color = palette.muted)
        }
        SuggestedNames(writer)
        FormulaHelp()
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp, Alignment.End)) {
            sheet.before?.let { before ->
                ToolButton("Remove this formula", text = "Remove", color = palette.error) {
                    if (formulas.remove(before)) close()
                }
            }
            ToolButton("Save the formula (Enter)", text = "OK", isOn = isReady(), isEnabled = isReady(), onClick = keep)
        }
    }
}

/** Saves the text if it is a formula, and closes the dialog. */
private fun keepFormula(formulas: FormulaStore, sheet: FormulaSheet, writer: FormulaWriter) {
    val topic = writer.topic ?: return
    val definition = writer.field.text.trim()
    if (sheet.before == null) formulas.add(definition, topic.name) else formulas.replace(sheet.before, definition, topic.name)
    formulas.closeSheet()
}

private fun handles(event: KeyEvent, writer: FormulaWriter, keep: () -> Unit, close: () -> Unit): Boolean {
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

/** The field for the definition of [writer]; mistakes are underlined. It initially has the keyboard focus. */
@Composable
internal fun FormulaField(writer: FormulaWriter) {
    val palette = LocalPalette.current
    val focus = remember { FocusRequester() }
    LaunchedEffect(writer) { focus.requestFocus() }
    val error = writer.error.takeIf { writer.remark?.isError == true }
    val interactions = remember { MutableInteractionSource() }
    BasicTextField(
        writer.field,
        { writer.field = it },
        Modifier
            .fillMaxWidth()
            .fieldFrame(interactions, horizontal = 10.dp, vertical = 8.dp, isWrong = error != null)
            .focusRequester(focus)
            .semantics { contentDescription = "Definition of the formula" },
        textStyle = LocalTextStyle.current.copy(color = palette.text, fontFamily = FontFamily.Monospace),
        maxLines = 6,
        interactionSource = interactions,
        visualTransformation = { TransformedText(underlined(it, error, palette), OffsetMapping.Identity) },
        cursorBrush = SolidColor(palette.accent),
    )
}

/** Returns [text] with the place of [error] underlined; if something is missing, with the character before it underlined. */
internal fun underlined(text: AnnotatedString, error: ExpressionError?, palette: Palette): AnnotatedString {
    // The error may belong to the text before the last key.
    if (error == null || error.text != text.text) return text
    val until = error.until.coerceIn(0, text.length)
    val from = error.from.coerceIn(0, until).let { if (it == until) maxOf(0, until - 1) else it }
    return buildAnnotatedString {
        append(text)
        addStyle(SpanStyle(palette.error, background = palette.errorSoft, textDecoration = TextDecoration.Underline), from, until)
    }
}

/** The suggested names; the arrow keys and Tab select like a click. */
@Composable
internal fun SuggestedNames(writer: FormulaWriter) {
    val palette = LocalPalette.current
    Column(Modifier.fillMaxWidth().heightIn(max = 200.dp)) {
        writer.suggestions.names.forEachIndexed { index, name ->
            NameText(
                name,
                Modifier
                    .fillMaxWidth()
                    .background(if (index == writer.marked) palette.accentSoft else Color.Transparent, RoundedCornerShape(4.dp))
                    .clickable { writer.take(index) }
                    .semantics {
                        contentDescription = "Insert $name"
                        selected = index == writer.marked
                    }
                    .padding(horizontal = 10.dp, vertical = 3.dp),
            )
        }
    }
}

/** A short summary of the syntax of formulas. */
@Composable
internal fun FormulaHelp() {
    val palette = LocalPalette.current
    Column(Modifier.padding(top = 4.dp)) {
        for (line in ESSENTIALS) {
            Text(line, color = palette.muted, fontFamily = FontFamily.Monospace, fontSize = 11.sp, lineHeight = 16.sp)
        }
        Text(REST, color = palette.muted, fontSize = 11.sp)
    }
}

private const val REST = "Quote names with special characters: \"…\". docs/expressions.md describes the language."

private val ESSENTIALS = listOf(
    "Power [W] = Battery Voltage * Total Current",
    "+ - * / % ^  < > == and or not  x when enabled  if(c, a, b)",
    "mean(x, 1 s)  derivative(x)  area(x)  delta(x)  shift(x, 0.1 s)  abs(x)",
)

/** The formulas that do not work for [open], and the reasons; a click edits one. Empty if all work. */
@Composable
internal fun UnmadeFormulas(formulas: FormulaStore, open: OpenRecording) {
    val unmade = open.formulas.mapNotNull { formula -> reasonFor(formula, open)?.let { formula to it } }
    if (unmade.isEmpty()) return
    HorizontalDivider()
    Column(Modifier.fillMaxWidth().heightIn(max = 160.dp).verticalScroll(rememberScrollState())) {
        for ((formula, reason) in unmade) UnmadeLine(formulas, formula.definition, reason)
    }
}

/** Returns the reason why [formula] does not work for [open], as a sentence; null if it works. */
internal fun reasonFor(formula: Formula, open: OpenRecording): String? =
    formula.error?.message ?: "It has no samples here.".takeIf { formula.name?.let(open::signal) == null }

@Composable
private fun UnmadeLine(formulas: FormulaStore, definition: String, reason: String) {
    val palette = LocalPalette.current
    ContextArea({ formulaMenu(formulas, definition) }) {
        Row(
            Modifier
                .fillMaxWidth()
                .clickable { formulas.edit(definition) }
                .semantics { contentDescription = "Formula without a topic: $definition" }
                .padding(start = 8.dp, end = 12.dp, top = 4.dp, bottom = 4.dp),
            Arrangement.spacedBy(6.dp),
        ) {
            Icon(Icons.Formula, contentDescription = null, Modifier.padding(top = 2.dp).size(13.dp), palette.muted)
            Column(Modifier.weight(1f)) {
                Text(definition, color = palette.muted, maxLines = 1, overflow = TextOverflow.Ellipsis)
                Text(reason, color = palette.muted, fontSize = 11.sp, maxLines = 3, overflow = TextOverflow.Ellipsis)
            }
        }
    }
}

/** Returns the context menu of the formula [definition]. */
internal fun formulaMenu(formulas: FormulaStore, definition: String): List<ContextMenuItem> = listOf(
    ContextMenuItem("Change the formula…") { formulas.edit(definition) },
    ContextMenuItem("Remove the formula") { formulas.remove(definition) },
)
