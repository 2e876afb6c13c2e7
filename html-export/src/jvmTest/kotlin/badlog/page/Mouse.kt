package badlog.page

import org.openqa.selenium.interactions.Actions
import org.openqa.selenium.interactions.PointerInput
import org.openqa.selenium.interactions.PointerInput.MouseButton
import org.openqa.selenium.interactions.PointerInput.Origin
import java.time.Duration

/** The mouse of all tests. Selenium's own moves take a quarter of a second each. */
private val MOUSE = PointerInput(PointerInput.Kind.MOUSE, "mouse")

/** Moves the mouse to a place of the window. */
internal fun Actions.mouseTo(x: Int, y: Int): Actions = tick(MOUSE.createPointerMove(Duration.ofMillis(10), Origin.viewport(), x, y))

/** Presses the mouse's main button, and holds it. */
internal fun Actions.mouseDown(): Actions = tick(MOUSE.createPointerDown(MouseButton.LEFT.asArg()))

/** Lets the mouse's main button go. */
internal fun Actions.mouseUp(): Actions = tick(MOUSE.createPointerUp(MouseButton.LEFT.asArg()))
