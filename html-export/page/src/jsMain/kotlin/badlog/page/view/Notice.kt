package badlog.page.view

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.showText
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/** A sentence about what was just done, over the page's lower edge; it disappears by itself. */
internal class Notice {
    private lateinit var text: HTMLElement
    private var timer = 0
    private var cancel = {}

    val element: HTMLElement = element("div", "notice card") {
        text = add("p") { setAttribute("role", "status") }
        addIconButton("", Icon.CLOSE, "Close") {
            cancel()
            hide()
        }
        classList.add("is-empty")
    }

    /** Shows [sentences]. */
    fun say(vararg sentences: String) {
        val said = sentences.joinToString(" ")
        if (said.isEmpty()) return
        show(said) {}
        timer = window.setTimeout(::hide, FIRST + said.length * PER_LETTER)
    }

    /** Shows [progress] until the next sentence; closing it calls [onCancel]. */
    fun show(progress: String, onCancel: () -> Unit) {
        cancel = onCancel
        text.showText(progress)
        element.classList.remove("is-empty")
        window.clearTimeout(timer)
    }

    /** Asks [question]; each of [choices] is a button. */
    fun ask(question: String, vararg choices: Pair<String, () -> Unit>) {
        show(question) {}
        for ((label, choose) in choices) {
            text.addButton("", label) {
                hide()
                choose()
            }
        }
    }

    /** Hides it. */
    fun hide() {
        element.classList.add("is-empty")
        text.showText("")
    }

    private companion object {
        /** Milliseconds for which every sentence stays, and additional ones for each character, for slow readers. */
        const val FIRST = 4000
        const val PER_LETTER = 80
    }
}
