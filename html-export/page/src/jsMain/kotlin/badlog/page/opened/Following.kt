package badlog.page.opened

import badlog.core.recording.Recording
import badlog.page.reading.FileReading
import badlog.page.reading.LogFileReader
import badlog.page.served.GrowingFile
import badlog.page.served.NotNow
import badlog.viewer.input.Action
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element
import org.w3c.dom.events.Event
import org.w3c.dom.events.KeyboardEvent
import org.w3c.files.File
import kotlin.js.Promise

/**
 * Follows [log], which is being written on the page's server, until a person touches the page.
 *
 * @param onGrown called with the log and what is in it now, when the page has done with what was there before.
 * @param onEnd called when it has ended; with a sentence, if nobody asked for that.
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
    private val pauseAt = { event: Event -> if ((event.target as? Element)?.closest("#live") == null && !isMark(event)) stop() }

    /** Starts. */
    fun start() {
        for (touch in TOUCHES) document.addEventListener(touch, pauseAt, true)
        ask()
    }

    /** Ends it. */
    fun stop(why: String? = null) {
        if (isOver) return
        isOver = true
        for (touch in TOUCHES) document.removeEventListener(touch, pauseAt, true)
        onEnd(why)
    }

    private fun ask() {
        if (isOver) return
        // The page still draws what was there before, or its rules are running over it.
        if (document.documentElement?.getAttribute("data-rules") == null) return askIn(PAUSE)
        file.more().then { grown ->
            misses = 0
            if (grown == null) askIn(file.pause) else read(grown).then { show(grown, it) }
        }.catch {
            // A Wi-Fi has gaps, and others' downloads end; and a server that ended an answer says why when it is asked again.
            if (it is NotNow && ++misses < MAX_MISSES) askIn(misses * GAP) else stop(it.message.orEmpty())
        }
    }

    // A worker takes longer to start than a small log takes to read.
    private fun read(grown: File): Promise<Recording> =
        if (grown.size.toDouble() < SMALL) LogFileReader(listOf(grown)) {}.read() else FileReading(listOf(grown)) {}.start()

    private fun show(grown: File, read: Recording) {
        if (isOver) return
        if (document.querySelector("#live:active") != null) {
            // The next page's button would be another one, which was not pressed.
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

    // Whoever marks a moment goes on to look at the newest.
    private fun isMark(event: Event): Boolean {
        val key = event.unsafeCast<KeyboardEvent>()
        return event.type == "keydown" && (key.key == "Shift" || Action.of(key.key.uppercase(), key.shiftKey) == Action.MARK)
    }

    private companion object {
        const val PAUSE = 10

        /** By how many ms the pause grows with each question that was not answered, and how many such questions end it: after 7 s. */
        const val GAP = 150
        const val MAX_MISSES = 10

        /** Bytes that are read in a fraction of a frame's patience. */
        const val SMALL = 4e6
        val TOUCHES = listOf("pointerdown", "keydown")
    }
}
