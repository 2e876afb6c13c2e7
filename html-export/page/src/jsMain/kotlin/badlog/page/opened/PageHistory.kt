package badlog.page.opened

import badlog.viewer.state.LogVisits
import badlog.viewer.state.Visit
import kotlinx.browser.window
import org.w3c.dom.History
import org.w3c.dom.PopStateEvent

/**
 * The page's entries in the browser's history.
 *
 * @param canShow returns whether a screen can be shown again.
 * @param onReturn called with the screen to show after Back or Forward.
 */
internal class PageHistory(private val canShow: (Visit) -> Boolean, private val onReturn: (Visit) -> Unit) {
    private var visits = LogVisits()
    private var isAllowed = true

    /** The shown screen. */
    val now: Visit get() = visits.now

    init {
        change { replaceState(stateAt(visits.at), "") }
        window.addEventListener("popstate", { go(it.unsafeCast<PopStateEvent>().state) })
    }

    /** Records that [next] is shown. */
    fun show(next: Visit) {
        val before = visits.at
        visits = visits.showing(next)
        val steps = visits.at - before
        change { if (steps > 0) pushState(stateAt(visits.at), "") else if (steps < 0) go(steps) }
    }

    private fun go(state: Any?) {
        // An address with another end has an entry without a state.
        if (state == null) {
            visits = visits.again()
            return change { replaceState(stateAt(visits.at), "") }
        }
        val place = "$state".substringAfter(LOADED, "").toIntOrNull() ?: return
        val before = visits.now
        visits = visits.returned(place, canShow) ?: return
        if (visits.now != before) onReturn(visits.now)
    }

    private fun change(step: History.() -> Unit) = try {
        if (isAllowed) window.history.step() else Unit
    } catch (_: Throwable) {
        // Pages in some frames have no history of their own.
        isAllowed = false
    }

    private fun stateAt(place: Int) = "$LOADED$place"

    private companion object {
        /** Differs each time the page is loaded, because nothing of what it showed before is left then. */
        val LOADED = "badlog ${window.performance.asDynamic().timeOrigin} "
    }
}
