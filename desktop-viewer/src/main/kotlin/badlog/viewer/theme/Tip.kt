package badlog.viewer.theme

import androidx.compose.foundation.ExperimentalFoundationApi
import androidx.compose.foundation.TooltipArea
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp

/** Explains [content] by [text] when the pointer rests on it. */
@OptIn(ExperimentalFoundationApi::class)
@Composable
internal fun Tip(text: String, modifier: Modifier = Modifier, content: @Composable () -> Unit) {
    TooltipArea(
        tooltip = {
            val palette = LocalPalette.current
            Text(
                text,
                Modifier
                    .widthIn(max = 420.dp)
                    .border(1.dp, palette.border, RoundedCornerShape(4.dp))
                    .background(palette.raised, RoundedCornerShape(4.dp))
                    .padding(horizontal = 8.dp, vertical = 4.dp),
                fontSize = 12.sp,
            )
        },
        modifier = modifier,
        content = content,
    )
}
