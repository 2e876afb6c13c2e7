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

    /** Whether the browser is on its way back to the place of [visits], which takes a moment. */
    private var isGoing = false

    /** The shown screen. */
    val now: Visit get() = visits.now

    init {
        mark()
        window.addEventListener("popstate", { arrive(it.unsafeCast<PopStateEvent>().state) })
    }

    /** Records that [next] is shown. */
    fun show(next: Visit) {
        visits = visits.showing(next)
        follow()
    }

    private fun follow() = change {
        // A new entry would be lost in the middle of going back. From an entry of another page, going back could leave this one.
        val at = placeIn(state).takeUnless { isGoing } ?: return@change
        for (place in at + 1..visits.at) pushState(stateAt(place), "")
        if (at <= visits.at) return@change
        // A browser may have dropped the page's first entry from a full history; going back would leave the page.
        isGoing = length < FULL
        if (isGoing) go(visits.at - at) else replaceState(stateAt(visits.at), "")
    }

    private fun arrive(state: Any?) {
        // An address with another end has an entry without a state.
        if (state == null) {
            visits = visits.again()
            return mark()
        }
        val at = placeIn(state) ?: return
        if (isGoing) {
            isGoing = false
            return follow()
        }
        val before = visits.now
        visits = visits.returned(at, canShow) ?: return
        if (visits.now != before) onReturn(visits.now)
    }

    private fun mark() = change { replaceState(stateAt(visits.at), "") }

    private fun change(step: History.() -> Unit) = try {
        if (isAllowed) window.history.step() else Unit
    } catch (_: Throwable) {
        // Pages in some frames have no history of their own.
        isAllowed = false
    }

    private fun stateAt(place: Int) = "$LOADED$place"

    /** Returns the place in the [state] of an entry; null if this page did not make it. */
    private fun placeIn(state: Any?) = "$state".substringAfter(LOADED, "").toIntOrNull()

    private companion object {
        /** The number of entries that Chromium and Firefox keep for a tab. */
        const val FULL = 50

        /** A text that differs each time the page is loaded, because its earlier screens are then gone. */
        val LOADED = "badlog ${window.performance.asDynamic().timeOrigin} "
    }
}
