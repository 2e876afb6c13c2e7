package badlog.viewer.formula

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.text.BasicTextField
import androidx.compose.material3.LocalTextStyle
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.input.OffsetMapping
import androidx.compose.ui.text.input.TransformedText
import androidx.compose.ui.text.style.TextDecoration
import androidx.compose.ui.unit.dp
import badlog.expression.ExpressionError
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.Palette

/** Where the definition of [writer] is typed; what is wrong in it is underlined. Has the keyboard from the beginning. */
@Composable
internal fun FormulaField(writer: FormulaWriter) {
    val palette = LocalPalette.current
    val focus = remember { FocusRequester() }
    LaunchedEffect(writer) { focus.requestFocus() }
    val error = writer.error
    BasicTextField(
        writer.field,
        { writer.field = it },
        Modifier
            .fillMaxWidth()
            .background(palette.raised, RoundedCornerShape(5.dp))
            .border(1.dp, if (error == null) palette.border else palette.error, RoundedCornerShape(5.dp))
            .padding(horizontal = 10.dp, vertical = 8.dp)
            .focusRequester(focus)
            .semantics { contentDescription = "Definition of the formula" },
        textStyle = LocalTextStyle.current.copy(color = palette.text, fontFamily = FontFamily.Monospace),
        maxLines = 6,
        visualTransformation = { TransformedText(underlined(it, error, palette), OffsetMapping.Identity) },
        cursorBrush = SolidColor(palette.accent),
    )
}

/** [text] with the place of [error] underlined; where something is missing, with what stands before it. */
internal fun underlined(text: AnnotatedString, error: ExpressionError?, palette: Palette): AnnotatedString {
    // The error may be that of the text before the last key.
    if (error == null || error.text != text.text) return text
    val until = error.until.coerceIn(0, text.length)
    val from = error.from.coerceIn(0, until).let { if (it == until) maxOf(0, until - 1) else it }
    return buildAnnotatedString {
        append(text)
        addStyle(SpanStyle(palette.error, background = palette.errorSoft, textDecoration = TextDecoration.Underline), from, until)
    }
}
