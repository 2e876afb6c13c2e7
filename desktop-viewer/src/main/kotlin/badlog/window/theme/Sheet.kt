package badlog.window.theme

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.shadow
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/** Makes an element a sheet above the window with the title [name], at most [widest] wide. */
@Composable
internal fun Modifier.sheet(name: String, widest: Dp): Modifier {
    val palette = LocalPalette.current
    val shape = RoundedCornerShape(8.dp)
    return padding(16.dp)
        .widthIn(max = widest)
        .shadow(12.dp, shape)
        .background(palette.surface, shape)
        .border(1.dp, palette.border, shape)
        .semantics { contentDescription = name }
}
