package badlog.page.opened

import badlog.core.recording.Recording
import badlog.page.dom.addButton
import badlog.page.view.PageStore
import kotlinx.browser.document
import org.w3c.dom.HTMLElement

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

    private companion object {
        const val ID = "live"
    }
}
