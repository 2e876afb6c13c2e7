package badlog.window.screen

import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.snapshotFlow
import androidx.compose.runtime.tooling.ComposeToolingApi
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.awt.ComposeWindow
import androidx.compose.ui.semantics.SemanticsNode
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.window.application
import badlog.fetch.RobotAddress
import badlog.files.UserFolders
import badlog.window.app.StartPlace
import badlog.window.app.Viewer
import badlog.window.app.ViewerWindow
import badlog.window.settings.Settings
import badlog.window.settings.SettingsFile
import badlog.window.settings.WindowPlace
import kotlinx.coroutines.delay
import java.awt.MouseInfo
import java.awt.Rectangle
import java.awt.Robot
import java.awt.event.InputEvent
import java.awt.event.KeyEvent
import java.awt.event.WindowEvent
import java.awt.image.BufferedImage
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.CopyOnWriteArrayList
import javax.imageio.ImageIO
import javax.swing.SwingUtilities
import kotlin.concurrent.thread
import kotlin.math.roundToInt

/**
 * The program as a person has it: a real window on a screen, with a mouse and a keyboard. Elements are found by their texts for screen
 * readers, so that a test names the element that it clicks.
 *
 * @param home the folder of the user's settings and cache.
 * @param opened the folder or file it is started on; null for none.
 */
@OptIn(ExperimentalComposeUiApi::class, ComposeToolingApi::class)
internal class RealWindow(
    home: Path,
    opened: Path?,
    width: Int = 1400,
    height: Int = 860,
    robots: (String) -> List<RobotAddress> = { RobotAddress.of(it) },
) : AutoCloseable {
    // It never waits for a quiet window: something always moves.
    private val robot = Robot().apply { autoDelay = 15 }

    @Volatile private var shown: ComposeWindow? = null

    @Volatile private var state: Viewer? = null

    private val said = CopyOnWriteArrayList<String>()

    init {
        // The window starts in the corner: elsewhere, without a window manager, Java may mistake its place.
        val settings = home.resolve("settings.json")
        if (!Files.exists(settings)) SettingsFile(settings).write(Settings(window = WindowPlace(0, 0, width, height, false)), Settings())
        robot.mouseMove(FAR, FAR)
    }

    private val application = thread(name = "viewer under test") {
        application(exitProcessOnExit = false) {
            ViewerWindow(
                folders = UserFolders(settings = home, cache = home),
                start = { StartPlace.of(opened?.toString(), it.settings.state, samples = null) },
                robots = robots,
            ) { viewer ->
                state = viewer
                LaunchedEffect(Unit) {
                    shown = window
                    snapshotFlow { viewer.notices.all.map { it.text } }.collect { said += it }
                }
            }
        }
    }

    init {
        await("the window") { shown?.isShowing == true }
        await("the keyboard") { window.isFocused }
    }

    /** The state of the window. Read it through [look]. */
    private val viewer: Viewer get() = checkNotNull(state)
    private val window: ComposeWindow get() = checkNotNull(shown)

    /** Returns the answer of [question], which reads the state of the window on its thread. */
    fun <T> look(question: (Viewer) -> T): T {
        var answer: Result<T>? = null
        SwingUtilities.invokeAndWait { answer = runCatching { question(viewer) } }
        return checkNotNull(answer).getOrThrow()
    }

    /** Waits until [isSo] holds of the state. */
    fun awaitState(what: String, isSo: (Viewer) -> Boolean) = await(what) { look(isSo) }

    /** Waits until a log is open, and all [count] of its folder are known. Findings make rows of the list higher, and move the others. */
    fun awaitLogs(count: Int) = awaitState("what is known of $count logs") { viewer ->
        viewer.current.recording != null && viewer.library.state.run { entries.size == count && reading == null && entries.all { it.found != null } }
    }

    /** Waits until a notice has contained [text]; the notice may be gone again. */
    fun awaitSaid(text: String) = await("a notice “$text”") { said.any { text in it } }

    /** Returns whether an element has the description or text [text]. */
    fun shows(text: String): Boolean = placeOf(text) != null

    /** Waits until an element has the description or text [text]. */
    fun awaitText(text: String) = await("“$text”") { shows(text) }

    /** Waits until no element has the description or text [text]. */
    fun awaitNo(text: String) = await("no “$text”") { !shows(text) }

    /**
     * Waits until the element with the description or text [text] is there and has not moved for a while. A window is drawn bit by bit. Its
     * thread is asked repeatedly, since time alone says nothing about a thread that a busy machine has stopped.
     */
    fun awaitRest(text: String) {
        var before: Rectangle? = null
        var looks = 0
        await("“$text” to stand still") {
            val now = placeOf(text)
            looks = if (now == before) looks + 1 else 0
            before = now
            now != null && looks >= REST_LOOKS
        }
    }

    /** Clicks [times] times on the element with the description or text [text]. Repeats it if a busy machine paused between the clicks. */
    fun click(text: String, times: Int = 1) {
        awaitRest(text)
        point(text, 0.5, 0.5)
        while (true) {
            val begin = System.nanoTime()
            repeat(times) {
                robot.mousePress(InputEvent.BUTTON1_DOWN_MASK)
                robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK)
            }
            if (times == 1 || System.nanoTime() - begin < DOUBLE_CLICK_MILLIS * 1_000_000) return
            // The next click must not be the second of a double click.
            Thread.sleep(DOUBLE_CLICK_MILLIS * 2)
        }
    }

    /** Presses the mouse at ([fromX], [fromY]) and releases it at ([toX], [toY]), in shares of the element described by [text]. */
    fun drag(text: String, fromX: Double, fromY: Double, toX: Double, toY: Double, vararg held: Int) {
        awaitRest(text)
        val place = checkNotNull(placeOf(text)) { "There is no “$text” to drag over." }
        fun move(x: Double, y: Double) = robot.mouseMove((place.x + place.width * x).roundToInt(), (place.y + place.height * y).roundToInt())
        move(fromX, fromY)
        for (key in held) robot.keyPress(key)
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK)
        for (step in 1..10) move(fromX + (toX - fromX) * step / 10, fromY + (toY - fromY) * step / 10)
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK)
        for (key in held) robot.keyRelease(key)
    }

    /**
     * Drags the element described by [text] to the middle of [target], until [isDone] holds. On a busy machine, a drop may come before the
     * drag that it ends.
     */
    fun dragTo(text: String, target: String, isDone: (Viewer) -> Boolean) = await("“$text” on “$target”") {
        awaitRest(text)
        awaitRest(target)
        dragOnce(text, target)
        (1..DROP_LOOKS).any {
            Thread.sleep(POLL_MILLIS)
            look(isDone)
        }
    }

    private fun dragOnce(text: String, target: String) {
        val to = checkNotNull(placeOf(target)) { "There is no “$target” to drag to." }
        point(text, 0.5, 0.5)
        val from = MouseInfo.getPointerInfo().location
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK)
        for (step in 1..20) {
            robot.mouseMove(
                (from.x + (to.centerX - from.x) * step / 20).roundToInt(),
                (from.y + (to.centerY - from.y) * step / 20).roundToInt(),
            )
            // Programs negotiate a drag through the screen; a release before that drops nothing.
            if (step == 5 || step == 20) robot.delay(HOLD_MILLIS)
        }
        robot.mouseMove(to.centerX.roundToInt() + 1, to.centerY.roundToInt() + 1)
        robot.delay(HOLD_MILLIS)
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK)
    }

    /** Points at the share ([x], [y]) of the element described by [text], without a click. */
    fun point(text: String, x: Double, y: Double) {
        val place = checkNotNull(placeOf(text)) { "There is no “$text” to point at." }
        robot.mouseMove((place.x + place.width * x).roundToInt(), (place.y + place.height * y).roundToInt())
    }

    /** Turns the wheel by [notches], towards the person if positive. */
    fun wheel(notches: Int, vararg held: Int) {
        for (key in held) robot.keyPress(key)
        robot.mouseWheel(notches)
        for (key in held) robot.keyRelease(key)
    }

    /** Presses [key] of [java.awt.event.KeyEvent] while [held] are down. */
    fun press(key: Int, vararg held: Int) {
        for (other in held) robot.keyPress(other)
        robot.keyPress(key)
        robot.keyRelease(key)
        for (other in held) robot.keyRelease(other)
    }

    /** Types the small letters, digits and signs of [text] on an American keyboard, once a field takes them. */
    fun type(text: String) {
        awaitState("a field to type into") { it.keyboard.isTyping }
        for (letter in text) press(KeyEvent.getExtendedKeyCodeForChar(letter.code))
    }

    /** Presses Tab until the element described by [text] has the keyboard focus. */
    fun tabTo(text: String) = await("the keyboard at “$text”") {
        val before = focused()
        press(KeyEvent.VK_TAB)
        // Otherwise a late key would move the focus on from there.
        for (i in 1..REST_LOOKS) if (focused() == before) Thread.sleep(POLL_MILLIS)
        isFocused(text)
    }

    /** Waits until every graph in sight is drawn. */
    fun awaitGraphs() = awaitState("the graphs") { it.graphs.plots.areReady(it.compared.drawn, it.view.viewport.visible) }

    /** Waits until [isSo] holds of the window's picture: a drawing may still be on its way to the screen. */
    fun awaitLook(what: String, isSo: (BufferedImage) -> Boolean) = await(what) { isSo(capture()) }

    /**
     * Keeps a picture of the window under build/screenshots, and returns it. With the environment variable `BADLOG_WRITE_GUIDE`, it is also
     * written into docs, as the picture [guide] of the guides.
     */
    fun picture(name: String, guide: String? = null): BufferedImage {
        Thread.sleep(if (guide == null || System.getenv("BADLOG_WRITE_GUIDE") == null) LOOK_MILLIS else PICTURE_MILLIS)
        val picture = capture()
        val folder = Files.createDirectories(Path.of("build/screenshots"))
        ImageIO.write(picture, "png", folder.resolve("$name.png").toFile())
        if (guide != null && System.getenv("BADLOG_WRITE_GUIDE") != null) writeGuidePicture(picture, guide)
        return picture
    }

    /** Returns the current picture of the window on the screen, with a mouse pointer at its place. */
    fun captureWithPointer(): BufferedImage {
        Thread.sleep(PICTURE_MILLIS)
        val corner = window.locationOnScreen
        val pointer = MouseInfo.getPointerInfo().location
        return capture().also { drawPointer(it, pointer.x - corner.x, pointer.y - corner.y) }
    }

    private fun capture(): BufferedImage = robot.createScreenCapture(Rectangle(window.locationOnScreen, window.size))

    /** Asks the window to close, like its frame, and waits until it has closed. */
    override fun close() {
        SwingUtilities.invokeLater { window.dispatchEvent(WindowEvent(window, WindowEvent.WINDOW_CLOSING)) }
        application.join(WAIT_MILLIS)
        check(!application.isAlive) { "The window does not close." }
    }

    /** Identifies the element with the keyboard focus; null if screen readers do not know it. */
    private fun focused(): Int? {
        var id: Int? = null
        SwingUtilities.invokeAndWait {
            id = window.semanticsOwners.firstNotNullOfOrNull { focusedIn(it.unmergedRootSemanticsNode) }
        }
        return id
    }

    private fun focusedIn(node: SemanticsNode): Int? = if (node.config.getOrNull(SemanticsProperties.Focused) == true) node.id else node.children.firstNotNullOfOrNull(::focusedIn)

    private fun isFocused(text: String): Boolean {
        var isSo = false
        SwingUtilities.invokeAndWait {
            val node = window.semanticsOwners.firstNotNullOfOrNull { find(it.unmergedRootSemanticsNode, text) }
            isSo = node?.config?.getOrNull(SemanticsProperties.Focused) == true
        }
        return isSo
    }

    private fun placeOf(text: String): Rectangle? {
        var place: Rectangle? = null
        SwingUtilities.invokeAndWait {
            val node = window.semanticsOwners.firstNotNullOfOrNull { find(it.unmergedRootSemanticsNode, text) }
            val bounds = node?.boundsInWindow ?: return@invokeAndWait
            val scale = window.graphicsConfiguration.defaultTransform.scaleX
            val corner = window.contentPane.locationOnScreen
            place = Rectangle(
                corner.x + (bounds.left / scale).toInt(),
                corner.y + (bounds.top / scale).toInt(),
                (bounds.width / scale).toInt(),
                (bounds.height / scale).toInt(),
            )
        }
        return place
    }

    private fun find(node: SemanticsNode, text: String): SemanticsNode? {
        val said = node.config.getOrNull(SemanticsProperties.ContentDescription).orEmpty() +
            node.config.getOrNull(SemanticsProperties.Text).orEmpty().map { it.text }
        if (text in said && !node.boundsInWindow.isEmpty) return node
        return node.children.firstNotNullOfOrNull { find(it, text) }
    }

    private fun await(what: String, isSo: () -> Boolean) {
        val end = System.nanoTime() + WAIT_MILLIS * 1_000_000
        while (!isSo()) {
            check(System.nanoTime() < end) { "Waited in vain for $what." }
            Thread.sleep(POLL_MILLIS)
        }
    }
}

private const val WAIT_MILLIS = 180_000L
private const val POLL_MILLIS = 20L

/** The time for which a person holds a dragged element before and after moving it. */
private const val HOLD_MILLIS = 300

/** A place beyond any window. */
private const val FAR = 5000

/** The number of looks, one every [POLL_MILLIS], after which an element that has not moved can be clicked. */
private const val REST_LOOKS = 8

/** The number of looks whether a drop was taken, before the drag is repeated. */
private const val DROP_LOOKS = 500

/** Clicks within this time are a double click. */
private const val DOUBLE_CLICK_MILLIS = 300L

/** The longest time that a picture is on its way to the screen, for published pictures. */
private const val PICTURE_MILLIS = 400L

/** The usual time that a picture is on its way to the screen. */
private const val LOOK_MILLIS = 150L
