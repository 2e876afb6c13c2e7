package badlog.page.opened

import badlog.core.recording.Recording
import badlog.page.dom.addButton
import badlog.page.view.PageStore
import kotlinx.browser.document
import org.w3c.dom.HTMLElement

/**
 * Follows the shown log while the page's server writes it, if a person wants that.
 *
 * @param shown returns the log that is shown; null for none.
 * @param onGrown called with that log and what is in it now.
 */
internal class LiveButton(private val shown: () -> OpenedLog?, private val onGrown: (OpenedLog, Recording) -> Unit) {
    private var following: Following? = null

    /** The state of the shown log; null if no log is shown. Whoever follows it stays at the end of each that is shown. */
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

    /** No longer follows. */
    fun stop() {
        following?.stop()
    }

    private fun toggle(address: String) {
        following?.let { return it.stop() }
        val log = shown() ?: return
        val from = store ?: return
        following = Following(log, address, onGrown) { why ->
            following = null
            // Each page has its own.
            val button = document.getElementById(ID) ?: return@Following
            button.setAttribute("aria-pressed", "false")
            if (why != null) button.textContent = "Live: $why"
        }
        document.getElementById(ID)?.apply {
            setAttribute("aria-pressed", "true")
            // Not what was wrong the last time.
            textContent = "Live"
        }
        following?.start(from)
    }

    private companion object {
        const val ID = "live"
    }
}
