package badlog.window.panel

import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.text.selection.SelectionContainer
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.panel.Trouble
import badlog.window.theme.LocalPalette

/** Shows [trouble] with its place in a file, if it has one. */
@Composable
internal fun TroubleView(trouble: Trouble) {
    Row(Modifier.fillMaxWidth().padding(start = 12.dp, end = 14.dp, top = 4.dp, bottom = 4.dp), Arrangement.spacedBy(8.dp)) {
        Box(Modifier.width(58.dp)) { SeverityBadge(trouble.severity, trouble.word) }
        SelectionContainer(Modifier.weight(1f)) {
            Column {
                Text(trouble.text, maxLines = 8, overflow = TextOverflow.Ellipsis)
                if (trouble.place.isNotEmpty()) {
                    Text(
                        trouble.place,
                        color = LocalPalette.current.muted,
                        fontSize = 12.sp,
                        maxLines = 2,
                        overflow = TextOverflow.Ellipsis,
                    )
                }
                if (trouble.pointer.isNotEmpty()) Pointer(trouble.pointer)
            }
        }
    }
}

@Composable
private fun Pointer(text: String) {
    val scroll = rememberScrollState()
    LaunchedEffect(text, scroll.maxValue) { scroll.scrollTo((scroll.maxValue * placeOfCarets(text)).toInt()) }
    // Not wrapped: a wrapped line would not be above its carets.
    Text(
        text.take(MAX_LETTERS),
        Modifier.horizontalScroll(scroll),
        fontFamily = FontFamily.Monospace,
        fontSize = 11.sp,
        lineHeight = 14.sp,
        softWrap = false,
    )
}

/** Returns the place of the carets in the last line of [text], as a share of its longest line, 0 to 1. */
private fun placeOfCarets(text: String): Float =
    text.lastIndexOf(' ').minus(text.lastIndexOf('\n')).toFloat() / text.lines().maxOf { it.length }.coerceAtLeast(1)

private const val MAX_LETTERS = 2000
