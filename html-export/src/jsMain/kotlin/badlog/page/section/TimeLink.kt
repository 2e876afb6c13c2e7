package badlog.page.section

import badlog.page.view.Scene
import kotlinx.browser.window

/**
 * The time that the page's address may name, as in `page.html#t=93.7`, in the unit of the x axis: the cursor goes there when the
 * page opens and when the address changes. Anything but a number is ignored; later times go to the recording's end.
 *
 * @param onJump is called with the time when the cursor was taken there.
 */
internal class TimeLink(private val scene: Scene, private val onJump: (Double) -> Unit) {
    /** Begins to follow the address. */
    fun start() {
        follow()
        window.addEventListener("hashchange", { follow() })
    }

    /** Goes to the time that the address names now. */
    fun follow() {
        val time = window.location.hash.takeIf { it.startsWith(MARK) }?.substring(MARK.length)?.toDoubleOrNull() ?: return
        if (!time.isFinite()) return
        scene.goTo(time)
        onJump(time)
    }

    companion object {
        private const val MARK = "#t="

        /** The end of the page's address that names [x]. */
        fun to(x: Double): String = MARK + x
    }
}
