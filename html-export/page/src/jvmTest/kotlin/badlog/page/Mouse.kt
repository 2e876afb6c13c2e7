package badlog.page

import org.openqa.selenium.interactions.Actions
import org.openqa.selenium.interactions.PointerInput
import org.openqa.selenium.interactions.PointerInput.MouseButton
import org.openqa.selenium.interactions.PointerInput.Origin
import java.time.Duration

/** The mouse of all tests. Selenium's own moves take a quarter of a second each. */
private val MOUSE = PointerInput(PointerInput.Kind.MOUSE, "mouse")

/** Moves the mouse to a position in the window. */
internal fun Actions.mouseTo(x: Int, y: Int): Actions = tick(MOUSE.createPointerMove(Duration.ofMillis(10), Origin.viewport(), x, y))

/** Presses the mouse's main button, and holds it. */
internal fun Actions.mouseDown(): Actions = tick(MOUSE.createPointerDown(MouseButton.LEFT.asArg()))

/** Releases the mouse's main button. */
internal fun Actions.mouseUp(): Actions = tick(MOUSE.createPointerUp(MouseButton.LEFT.asArg()))

/** Double-clicks at a position in the window. */
internal fun OpenPage.doubleClick(x: Int, y: Int) = clicks(listOf(x to y, x to y), pause = 0.1)

/**
 * Clicks at [places] of the window, with [pause] seconds before each click. The events carry these times, so a slow machine does not
 * matter.
 */
internal fun OpenPage.clicks(places: List<Pair<Int, Int>>, pause: Double) {
    act { mouseTo(places.first().first, places.first().second) }
    val begin = now()
    places.forEachIndexed { index, (x, y) ->
        for ((type, buttons) in listOf("mousePressed" to 1, "mouseReleased" to 0)) {
            driver.executeCdpCommand(
                "Input.dispatchMouseEvent",
                mapOf("type" to type, "x" to x, "y" to y, "button" to "left", "buttons" to buttons, "clickCount" to 1, "timestamp" to begin + (index + 1) * pause),
            )
        }
    }
    settle()
}

/** Taps with a finger at [places] of the window, timed as in [clicks]. */
internal fun OpenPage.taps(places: List<Pair<Int, Int>>, pause: Double) {
    val begin = now()
    places.forEachIndexed { index, (x, y) ->
        for ((type, fingers) in listOf("touchStart" to listOf(mapOf("x" to x, "y" to y)), "touchEnd" to emptyList())) {
            driver.executeCdpCommand(
                "Input.dispatchTouchEvent",
                mapOf("type" to type, "touchPoints" to fingers, "timestamp" to begin + (index + 1) * pause),
            )
        }
    }
    settle()
}

/** Returns the time of the browser's clock, in seconds. */
private fun OpenPage.now() = number("return performance.timeOrigin + performance.now()") / 1000
