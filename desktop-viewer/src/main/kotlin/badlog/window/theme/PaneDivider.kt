package badlog.window.theme

import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.gestures.detectTapGestures
import androidx.compose.foundation.gestures.draggable
import androidx.compose.foundation.gestures.rememberDraggableState
import androidx.compose.foundation.hoverable
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.interaction.collectIsHoveredAsState
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.width
import androidx.compose.material3.VerticalDivider
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import java.awt.Cursor

/**
 * The line between two parts of the window, which a person can drag.
 *
 * @param onDrag receives the distance of a drag to the right, in dp.
 * @param onReset is called for a double click.
 */
@Composable
internal fun PaneDivider(description: String, onDrag: (Float) -> Unit, onReset: () -> Unit) {
    val palette = LocalPalette.current
    val density = LocalDensity.current.density
    val drag by rememberUpdatedState(onDrag)
    val reset by rememberUpdatedState(onReset)
    val interactions = remember { MutableInteractionSource() }
    val isHovered by interactions.collectIsHoveredAsState()
    Box(
        Modifier
            .width(5.dp)
            .fillMaxHeight()
            .hoverable(interactions)
            .pointerHoverIcon(PointerIcon(Cursor(Cursor.E_RESIZE_CURSOR)))
            .pointerInput(Unit) { detectTapGestures(onDoubleTap = { reset() }) }
            .draggable(rememberDraggableState { drag(it / density) }, Orientation.Horizontal)
            .semantics { contentDescription = description },
        contentAlignment = Alignment.Center,
    ) {
        VerticalDivider(thickness = if (isHovered) 3.dp else 1.dp, color = if (isHovered) palette.accent else palette.border)
    }
}
