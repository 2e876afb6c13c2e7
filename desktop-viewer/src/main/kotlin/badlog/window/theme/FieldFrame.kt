package badlog.window.theme

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.interaction.InteractionSource
import androidx.compose.foundation.interaction.collectIsFocusedAsState
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/**
 * Draws the frame around a text field with these [interactions]. It shows whether the field has the keyboard focus, and whether its text
 * [isWrong].
 */
@Composable
internal fun Modifier.fieldFrame(interactions: InteractionSource, horizontal: Dp, vertical: Dp, isWrong: Boolean = false): Modifier {
    val palette = LocalPalette.current
    val isFocused by interactions.collectIsFocusedAsState()
    val color = when {
        isWrong -> palette.error
        isFocused -> palette.accent
        else -> palette.border
    }
    return background(palette.raised, SHAPE).border(if (isFocused) 2.dp else 1.dp, color, SHAPE).padding(horizontal, vertical)
}

private val SHAPE = RoundedCornerShape(5.dp)
