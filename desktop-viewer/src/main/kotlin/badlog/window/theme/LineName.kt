package badlog.window.theme

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.style.TextDecoration
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp

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
