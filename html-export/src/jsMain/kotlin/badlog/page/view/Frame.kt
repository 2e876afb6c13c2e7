package badlog.page.view

import kotlinx.browser.window

/** Does [work] once before the browser's next picture, however often it is asked to. */
internal class Frame(private val work: () -> Unit) {
    private var isAsked = false

    /** Asks for [work] to be done. */
    fun ask() {
        if (isAsked) return
        isAsked = true
        window.requestAnimationFrame {
            isAsked = false
            work()
        }
    }
}
