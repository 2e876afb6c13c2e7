package badlog.viewer.findings

import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.rememberScrollState
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.sp
import badlog.viewer.theme.LocalPalette

/** A mistake in a file of rules: a sentence, and where [text] has more lines, a place in the file with carets below it. */
@Composable
internal fun PointedText(text: String) {
    val palette = LocalPalette.current
    Column {
        Text(text.substringBefore('\n'), color = palette.error, maxLines = 8, overflow = TextOverflow.Ellipsis)
        val place = text.substringAfter('\n', "")
        if (place.isEmpty()) return@Column
        val scroll = rememberScrollState()
        LaunchedEffect(place, scroll.maxValue) { scroll.scrollTo((scroll.maxValue * placeOfCarets(place)).toInt()) }
        // A line that was broken would not stand above its carets.
        Text(
            place.take(MOST_LETTERS),
            Modifier.horizontalScroll(scroll),
            fontFamily = FontFamily.Monospace,
            fontSize = 11.sp,
            lineHeight = 14.sp,
            softWrap = false,
        )
    }
}

/** Where in the longest line of [text] the carets of its last one stand, from 0 to 1. */
private fun placeOfCarets(text: String): Float =
    text.lastIndexOf(' ').minus(text.lastIndexOf('\n')).toFloat() / text.lines().maxOf { it.length }.coerceAtLeast(1)

private const val MOST_LETTERS = 2000
