package badlog.window.theme

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.LocalContentColor
import androidx.compose.material3.LocalTextStyle
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawWithCache
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.takeOrElse
import androidx.compose.ui.layout.layout
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.text
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.TextLayoutResult
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextDecoration
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.TextUnit
import androidx.compose.ui.unit.constrain
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.shown.folder.beginsWord
import kotlin.math.ceil

/** The part that a name loses if it is too long. */
internal enum class NameCut {
    /** Its beginning: for topics and graphs, which differ at their end. */
    BEGINNING,

    /** Its middle: for other files and sentences with a name at their end. */
    MIDDLE,

    /** Whole words in its middle, if possible: for files of logs. */
    FILE,

    /** Its first words: for the events where matches are played, as a part of a word says little. */
    WORDS,
    ;

    companion object {
        /**
         * Returns the part that the name of a topic or graph loses. Calculated topics lose their middle: all derivatives end alike, as in
         * `[ Left Position Derivative ]`.
         */
        fun of(name: CharSequence): NameCut = if (name.endsWith("]")) MIDDLE else BEGINNING
    }
}

/**
 * A name in one line, which keeps its end. Use it instead of a `Text` with `TextOverflow.StartEllipsis`, as Compose cuts that at the end
 * here.
 */
@Composable
internal fun NameText(
    name: AnnotatedString,
    modifier: Modifier = Modifier,
    color: Color = Color.Unspecified,
    fontSize: TextUnit = TextUnit.Unspecified,
    fontWeight: FontWeight? = null,
    textAlign: TextAlign = TextAlign.Start,
    textDecoration: TextDecoration? = null,
    cut: NameCut = NameCut.of(name),
) {
    val letters = rememberTextMeasurer(MEASURED)
    val given = LocalTextStyle.current
    val style = given.merge(
        color = color.takeOrElse { given.color.takeOrElse { LocalContentColor.current } },
        fontSize = fontSize,
        fontWeight = fontWeight,
        textDecoration = textDecoration,
    )
    Spacer(
        modifier
            .semantics { text = name }
            .layout { measurable, constraints ->
                val size = constraints.constrain(letters.measure(name, style, softWrap = false, maxLines = 1).size)
                val placeable = measurable.measure(Constraints.fixed(size.width, size.height))
                layout(size.width, size.height) { placeable.place(0, 0) }
            }
            .drawWithCache {
                val shown = letters.measureName(name, style, size.width.toInt(), cut)
                val left = if (textAlign == TextAlign.End) size.width - shown.size.width else 0f
                onDrawBehind { drawText(shown, topLeft = Offset(left, (size.height - shown.size.height) / 2)) }
            },
    )
}

/** Draws a name in a single style in the same way. */
@Composable
internal fun NameText(
    name: String,
    modifier: Modifier = Modifier,
    color: Color = Color.Unspecified,
    fontSize: TextUnit = TextUnit.Unspecified,
    fontWeight: FontWeight? = null,
    textAlign: TextAlign = TextAlign.Start,
    textDecoration: TextDecoration? = null,
    cut: NameCut = NameCut.of(name),
) = NameText(AnnotatedString(name), modifier, color, fontSize, fontWeight, textAlign, textDecoration, cut)

/** Returns [name] as it is drawn in [width] pixels: whole, or with an ellipsis where it is [cut]. */
internal fun TextMeasurer.measureName(name: AnnotatedString, style: TextStyle, width: Int, cut: NameCut): TextLayoutResult {
    val whole = measure(name, style, softWrap = false, maxLines = 1)
    if (whole.size.width <= width) return whole
    val room = width - measure(ELLIPSIS, style).size.width
    val fitting = if (cut == NameCut.MIDDLE || cut == NameCut.FILE) whole.lastWithin(room / 2) else 0
    val head = if (cut == NameCut.FILE) (fitting downTo 1).firstOrNull { beginsWord(name, it) } ?: fitting else fitting
    val letters = whole.firstBeyond(whole.size.width - room + whole.placeOf(head))
    val tail = when (cut) {
        NameCut.WORDS -> wordFrom(name, letters)
        NameCut.FILE -> (letters until name.length).firstOrNull { beginsWord(name, it) }
        else -> null
    } ?: letters
    val end = name.subSequence(tail + name.drop(tail).takeWhile { it.isWhitespace() }.length, name.length)
    val shown = name.subSequence(0, head) + AnnotatedString(ELLIPSIS) + end
    // Where scripts of both directions mix, places do not follow the order of letters. It may still be too long.
    return measure(shown, style, TextOverflow.Ellipsis, softWrap = false, maxLines = 1, constraints = Constraints(maxWidth = width))
}

/** Returns the place of the first word of [name] that begins at [from] or behind it. Returns null if there is none. */
private fun wordFrom(name: CharSequence, from: Int): Int? =
    (maxOf(1, from) until name.length).firstOrNull { name[it - 1].isWhitespace() && !name[it].isWhitespace() }

/** Returns the number of first letters that end at [x] or before. */
private fun TextLayoutResult.lastWithin(x: Int): Int = (nearest(x) downTo 0).first { it == 0 || (placeOf(it) <= x && isBetweenLetters(it)) }

/** Returns the index of the first letter that begins at [x] or behind it. */
private fun TextLayoutResult.firstBeyond(x: Float): Int {
    val end = layoutInput.text.length
    return (nearest(ceil(x).toInt())..end).first { it == end || (placeOf(it) >= x && isBetweenLetters(it)) }
}

private fun TextLayoutResult.nearest(x: Int) = getOffsetForPosition(Offset(x.toFloat(), 0f))

private fun TextLayoutResult.placeOf(index: Int) = getHorizontalPosition(index, usePrimaryDirection = true)

/** Returns whether the text can be cut at [index]: not inside a letter of two characters. */
private fun TextLayoutResult.isBetweenLetters(index: Int) = index >= layoutInput.text.length || !layoutInput.text[index].isLowSurrogate()

private const val ELLIPSIS = "…"

/** The number of layouts that are kept. The whole name is measured for its size, and again when it is drawn. */
private const val MEASURED = 3

/** The color of a line in a legend, by its number; pale if the line is hidden. */
@Composable
internal fun LineColor(number: Int, isHidden: Boolean) {
    val color = LocalPalette.current.line(number).copy(alpha = if (isHidden) HIDDEN else 1f)
    Spacer(Modifier.size(10.dp, 3.dp).background(color, RoundedCornerShape(2.dp)))
}

/** The name of a line in a legend, struck out if the line is hidden. */
@Composable
internal fun LineName(name: String, isHidden: Boolean) {
    val palette = LocalPalette.current
    NameText(
        name,
        Modifier.widthIn(max = 260.dp),
        color = if (isHidden) palette.muted else palette.text,
        fontSize = 12.sp,
        textDecoration = if (isHidden) TextDecoration.LineThrough else null,
    )
}

private const val HIDDEN = 0.35f
