package badlog.page.view

import kotlinx.browser.window

/** Runs [work] once before the browser's next frame, however often it is requested. */
internal class Frame(private val work: () -> Unit) {
    private var isAsked = false

    /** Requests [work]. */
    fun ask() {
        if (isAsked) return
        isAsked = true
        window.requestAnimationFrame {
            isAsked = false
            work()
        }
    }
}
