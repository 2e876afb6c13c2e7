package badlog.page.view

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.showText
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/** A sentence about what was just done, over the page's lower edge; it goes by itself. */
internal class Notice {
    private lateinit var text: HTMLElement
    private var timer = 0

    val element: HTMLElement = element("div", "notice card") {
        text = add("p") { setAttribute("role", "status") }
        addIconButton("", Icon.CLOSE, "Close") { hide() }
        classList.add("is-empty")
    }

    /** Says [sentences]. */
    fun say(vararg sentences: String) {
        val said = sentences.joinToString(" ")
        if (said.isEmpty()) return
        text.showText(said)
        element.classList.remove("is-empty")
        window.clearTimeout(timer)
        timer = window.setTimeout(::hide, FIRST + said.length * PER_LETTER)
    }

    private fun hide() {
        element.classList.add("is-empty")
        text.showText("")
    }

    private companion object {
        /** Milliseconds that every sentence stays, and that each of its letters takes to be read by somebody who reads slowly. */
        const val FIRST = 4000
        const val PER_LETTER = 80
    }
}
