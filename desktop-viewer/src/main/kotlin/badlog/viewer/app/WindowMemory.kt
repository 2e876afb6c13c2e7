package badlog.viewer.app

import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import androidx.compose.ui.window.WindowPlacement
import androidx.compose.ui.window.WindowPosition
import androidx.compose.ui.window.WindowState
import badlog.viewer.settings.WindowPlace
import java.awt.GraphicsEnvironment
import java.awt.Rectangle

/** The window where it was last, or in the middle when that is not to be seen on any of [screens], given in dp. */
internal fun windowStateOf(place: WindowPlace?, screens: List<Rectangle> = screens()): WindowState {
    val size = place?.let { DpSize(it.width.dp, it.height.dp) } ?: USUAL_SIZE
    val isSeen = place != null && screens.any { it.intersects(place.x + 8.0, place.y + 8.0, 64.0, 24.0) }
    return WindowState(
        placement = if (place?.isMaximized == true) WindowPlacement.Maximized else WindowPlacement.Floating,
        position = if (place != null && isSeen) WindowPosition(place.x.dp, place.y.dp) else WindowPosition.PlatformDefault,
        size = size,
    )
}

/** Where the window is now. A window that fills the screen keeps the size of [before], to return to. */
internal fun placeOf(state: WindowState, before: WindowPlace?): WindowPlace {
    val isMaximized = state.placement != WindowPlacement.Floating
    if (isMaximized && before != null) return before.copy(isMaximized = true)
    return WindowPlace(
        x = state.position.x.value.takeIf { it.isFinite() }?.toInt() ?: 0,
        y = state.position.y.value.takeIf { it.isFinite() }?.toInt() ?: 0,
        width = state.size.width.value.toInt(),
        height = state.size.height.value.toInt(),
        isMaximized = isMaximized,
    )
}

private fun screens(): List<Rectangle> =
    if (GraphicsEnvironment.isHeadless()) emptyList()
    else GraphicsEnvironment.getLocalGraphicsEnvironment().screenDevices.map { it.defaultConfiguration.bounds }

private val USUAL_SIZE = DpSize(1400.dp, 860.dp)
