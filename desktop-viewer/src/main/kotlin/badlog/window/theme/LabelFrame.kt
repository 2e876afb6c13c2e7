package badlog.window.theme

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.unit.dp

/** Makes an element a small label over graphs, with a border of this [color]. */
@Composable
internal fun Modifier.labelFrame(color: Color): Modifier = this
    .border(1.dp, color, SHAPE)
    .background(LocalPalette.current.raised, SHAPE)
    .padding(horizontal = 8.dp, vertical = 3.dp)

private val SHAPE = RoundedCornerShape(4.dp)
