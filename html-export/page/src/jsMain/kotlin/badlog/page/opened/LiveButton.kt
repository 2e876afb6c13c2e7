package badlog.page.opened

import badlog.core.recording.Recording
import badlog.page.dom.addButton
import badlog.page.reading.FileReading
import badlog.page.reading.LogFileReader
import badlog.page.served.GrowingFile
import badlog.page.served.RetryLaterException
import badlog.page.view.PageStore
import badlog.viewer.state.EndFollowing
import badlog.viewer.state.PlaceAction
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element
import org.w3c.dom.HTMLElement
import org.w3c.dom.events.Event
import org.w3c.dom.events.KeyboardEvent
import org.w3c.dom.events.MouseEvent
import org.w3c.files.File
import kotlin.js.Promise

/**
 * The button that follows the shown log while the page's server writes it.
 *
 * @param shown returns the log that is shown; null if there is none.
 * @param onGrown called with that log and its current recording.
 */
internal class LiveButton(private val shown: () -> OpenedLog?, private val onGrown: (OpenedLog, Recording) -> Unit) {
    private var following: Following? = null

    /** The state of the shown log's page; null if no log is shown. While following, each new page stays at the end of the log. */
    var store: PageStore? = null
        set(value) {
            field = value
            if (value != null) following?.stayAt(value)
        }

    /** Adds the button to [tools]; it follows the file at [address]. */
    fun addTo(tools: HTMLElement, address: String) {
        tools.addButton("", "Live", "Follow the log while the robot writes it; going elsewhere in it pauses") { toggle(address) }.apply {
            id = ID
            setAttribute("aria-pressed", (following != null).toString())
        }
    }

    /** Stops following. */
    fun stop() {
        following?.stop()
    }

    private fun toggle(address: String) {
        following?.let { return it.stop() }
        val log = shown() ?: return
        val from = store ?: return
        following = Following(log, address, onGrown) { why ->
            following = null
            // Each page has its own button.
            val button = document.getElementById(ID) ?: return@Following
            button.setAttribute("aria-pressed", "false")
            if (why != null) button.textContent = "Live: $why"
        }
        document.getElementById(ID)?.apply {
            setAttribute("aria-pressed", "true")
            // Removes the reason why following ended the last time.
            textContent = "Live"
        }
        following?.start(from)
    }
}

/**
 * Follows [log], which is being written on the page's server. It ends when a person goes elsewhere in the log, see [EndFollowing], or
 * begins something that would be lost. The grown log is shown on a new page.
 *
 * @param onGrown called with the log and its new content, once the page has finished with the previous content.
 * @param onEnd called when following has ended; with the reason as a sentence if it ended by itself.
 */
internal class Following(
    private var log: OpenedLog,
    address: String,
    private val onGrown: (OpenedLog, Recording) -> Unit,
    private val onEnd: (why: String?) -> Unit,
) {
    private val file = GrowingFile(log.files[0], address)
    private var isOver = false
    private var misses = 0
    private var following = EndFollowing()
    private var followed: PageStore? = null
    private var isPressed = false
    private val onPress = { event: Event ->
        // Where another button is let go, the page may never know: over the browser’s menu, for example.
        if (event.unsafeCast<MouseEvent>().button.toInt() == 0) {
            isPressed = true
            if (isLost(event.target)) stop()
        }
    }
    private val onKey = { event: Event ->
        val key = event.unsafeCast<KeyboardEvent>().key
        if (key == "Tab" || (key in PRESSING && isLost(document.activeElement))) stop()
    }
    private val onRelease = { _: Event -> isPressed = false }
    private val listeners = listOf("pointerdown" to onPress, "keydown" to onKey) +
        listOf("pointerup", "pointercancel", "contextmenu").map { it to onRelease }

    /** Starts with [store], the state of the page that the reader sees. */
    fun start(store: PageStore) {
        for ((type, listener) in listeners) document.addEventListener(type, listener, true)
        // Only of the window: elements that lose the focus do so because something is pressed.
        window.addEventListener("blur", onRelease)
        store.send(PlaceAction.GoToEnd)
        stayAt(store)
        ask()
    }

    /** Continues with [store], the state of the page that shows the end of the log. */
    fun stayAt(store: PageStore) {
        followed = store
        following = following.begun(store.place)
        store.onChange { if (store === followed && store.place !== it.place && !following.isAt(store.place)) stop() }
    }

    /** Stops following. [why] is the reason if it ends by itself; otherwise null. */
    fun stop(why: String? = null) {
        if (isOver) return
        isOver = true
        for ((type, listener) in listeners) document.removeEventListener(type, listener, true)
        window.removeEventListener("blur", onRelease)
        onEnd(why)
    }

    private fun ask() {
        if (isOver) return
        // The page still draws the content before, or its rules are running over it.
        if (document.documentElement?.getAttribute("data-rules") == null) return askIn(PAUSE)
        file.more().then { grown ->
            misses = 0
            if (grown == null) askIn(file.pause) else read(grown).then { show(grown, it) }
        }.catch {
            // A Wi-Fi has gaps, and others' downloads end. A server that ended an answer says why when it is asked again.
            if (it is RetryLaterException && ++misses < MAX_MISSES) askIn(misses * GAP) else stop(it.message.orEmpty())
        }
    }

    // A worker takes longer to start than a small log takes to read.
    private fun read(grown: File): Promise<Recording> = if (grown.size.toDouble() < SMALL) {
        LogFileReader(listOf(grown)) {}.read()
    } else {
        FileReading(listOf(grown)) {}.start().then { it.recording }
    }

    private fun show(grown: File, read: Recording) {
        if (isOver) return
        if (document.querySelector(BEGUN) != null) return stop()
        if (isPressed) {
            // The pressed element would be gone when the button is released.
            window.setTimeout({ show(grown, read) }, PAUSE)
            return
        }
        log = log.growing(grown)
        onGrown(log, read)
        askIn(file.pause)
    }

    private fun askIn(millis: Int) {
        window.setTimeout({ ask() }, millis)
    }

    /** Whether the next page would not have what [target] does when it is pressed: some lists unfold, for example. */
    private fun isLost(target: Any?): Boolean {
        val pressed = target as? Element
        return pressed?.closest(PRESSED) != null && pressed.closest(KEPT) == null
    }

    private companion object {
        const val PAUSE = 10

        /**
         * The growth of the pause, in ms, after each request without an answer. Following ends after [MAX_MISSES] such requests, about 7 s.
         */
        const val GAP = 150
        const val MAX_MISSES = 10

        /** The maximum size, in bytes, of a log that is read without a worker. */
        const val SMALL = 4e6

        /** The elements that respond to a press. */
        const val PRESSED = "button, a, input, select, textarea, summary"

        /** The elements that stay, or lead to a place that decides whether following ends. */
        const val KEPT = "#live, .pin, .zoom-buttons, #values-button, #modules-button, #board :is(.legend-entry, .statistics-toggle)"

        /** The elements with unsaved input. */
        const val BEGUN = "dialog[open], .menu, :is(input, select, textarea):focus"
        val PRESSING = listOf("Enter", " ")
    }
}

private const val ID = "live"
