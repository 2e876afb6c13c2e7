package badlog.window.panel

import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.panel.Trouble
import badlog.window.findings.findingColor
import badlog.window.theme.LocalPalette

/** Shows [trouble] with its place in a file, if it has one. */
@Composable
internal fun TroubleView(trouble: Trouble) {
    Column(Modifier.padding(horizontal = 12.dp, vertical = 4.dp)) {
        Text(trouble.text, color = LocalPalette.current.findingColor(trouble.severity), maxLines = 8, overflow = TextOverflow.Ellipsis)
        if (trouble.pointer.isEmpty()) return@Column
        val scroll = rememberScrollState()
        LaunchedEffect(trouble.pointer, scroll.maxValue) { scroll.scrollTo((scroll.maxValue * placeOfCarets(trouble.pointer)).toInt()) }
        // Not wrapped: a wrapped line would not be above its carets.
        Text(
            trouble.pointer.take(MAX_LETTERS),
            Modifier.horizontalScroll(scroll),
            fontFamily = FontFamily.Monospace,
            fontSize = 11.sp,
            lineHeight = 14.sp,
            softWrap = false,
        )
    }
}

/** Returns the place of the carets in the last line of [text], as a share of its longest line, 0 to 1. */
private fun placeOfCarets(text: String): Float =
    text.lastIndexOf(' ').minus(text.lastIndexOf('\n')).toFloat() / text.lines().maxOf { it.length }.coerceAtLeast(1)

private const val MAX_LETTERS = 2000
