package badlog.window.app

import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import androidx.compose.ui.window.WindowPlacement
import androidx.compose.ui.window.WindowPosition
import androidx.compose.ui.window.WindowState
import badlog.window.settings.WindowPlace
import java.awt.GraphicsConfiguration
import java.awt.GraphicsEnvironment
import java.awt.Rectangle
import java.awt.Toolkit

/**
 * Returns the window at its last [place], moved onto its screen if it reaches beyond an edge. If it was on none of [screens], given in dp,
 * it is in the middle of the first. Without a [place], it fills a screen that is smaller than the usual size.
 */
internal fun windowStateOf(place: WindowPlace?, screens: List<Rectangle> = screens()): WindowState {
    val seenOn = place?.let { screens.firstOrNull { it.intersects(place.x + 8.0, place.y + 8.0, 64.0, 24.0) } }
    val screen = seenOn ?: screens.firstOrNull()
    val width = (place?.width ?: USUAL_WIDTH).within(MIN_WIDTH, screen?.width)
    val height = (place?.height ?: USUAL_HEIGHT).within(MIN_HEIGHT, screen?.height)
    val isSmall = screen != null && (screen.width < USUAL_WIDTH || screen.height < USUAL_HEIGHT)
    return WindowState(
        placement = if (place?.isMaximized ?: isSmall) WindowPlacement.Maximized else WindowPlacement.Floating,
        position = if (screen == null) {
            WindowPosition.PlatformDefault
        } else {
            val x = if (place != null && seenOn != null) place.x else screen.x + (screen.width - width) / 2
            val y = if (place != null && seenOn != null) place.y else screen.y + (screen.height - height) / 2
            WindowPosition(
                x.coerceIn(screen.x, maxOf(screen.x, screen.x + screen.width - width)).dp,
                y.coerceIn(screen.y, maxOf(screen.y, screen.y + screen.height - height)).dp,
            )
        },
        size = DpSize(width.dp, height.dp),
    )
}

private fun Int.within(least: Int, most: Int?) = coerceAtMost(most ?: this).coerceAtLeast(least)

/** Returns the current place of the window. A maximized window keeps the size of [before], to return to. */
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

private fun screens(): List<Rectangle> = if (GraphicsEnvironment.isHeadless()) {
    emptyList()
} else {
    GraphicsEnvironment.getLocalGraphicsEnvironment().screenDevices.map { usablePart(it.defaultConfiguration) }
}

/** Returns the part of a screen that the system's own bars leave free. */
private fun usablePart(screen: GraphicsConfiguration): Rectangle {
    val bars = Toolkit.getDefaultToolkit().getScreenInsets(screen)
    val all = screen.bounds
    return Rectangle(all.x + bars.left, all.y + bars.top, all.width - bars.left - bars.right, all.height - bars.top - bars.bottom)
}

private const val USUAL_WIDTH = 1400
private const val USUAL_HEIGHT = 860
private const val MIN_WIDTH = 320
private const val MIN_HEIGHT = 240
