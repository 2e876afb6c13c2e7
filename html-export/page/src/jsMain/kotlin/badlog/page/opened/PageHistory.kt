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

    /** The place of the browser, which follows [visits]: going back takes a moment, in which it [isGoing]. */
    private var at = 0
    private var isGoing = false

    /** The shown screen. */
    val now: Visit get() = visits.now

    init {
        change { replaceState(stateAt(at), "") }
        window.addEventListener("popstate", { arrive(it.unsafeCast<PopStateEvent>().state) })
    }

    /** Records that [next] is shown. */
    fun show(next: Visit) {
        visits = visits.showing(next)
        follow()
    }

    private fun follow() = change {
        // A new entry would be lost in the middle of going back.
        if (isGoing) return@change
        while (at < visits.at) pushState(stateAt(++at), "")
        isGoing = at > visits.at
        if (isGoing) go(visits.at - at)
    }

    private fun arrive(state: Any?) {
        // An address with another end has an entry without a state.
        if (state == null) {
            visits = visits.again()
            at = visits.at
            return change { replaceState(stateAt(at), "") }
        }
        at = "$state".substringAfter(LOADED, "").toIntOrNull() ?: return
        if (isGoing) {
            isGoing = false
            return follow()
        }
        val before = visits.now
        visits = visits.returned(at, canShow) ?: return
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
        /** Differs each time the page is loaded, because its earlier screens are gone then. */
        val LOADED = "badlog ${window.performance.asDynamic().timeOrigin} "
    }
}
