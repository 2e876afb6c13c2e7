package badlog.page.view

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.showText
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/** A message about the last action, over the page's lower edge; it disappears by itself. */
internal class Notice {
    private lateinit var text: HTMLElement
    private var timer = 0
    private var cancel = {}
    private var isAsking = false

    val element: HTMLElement = element("div", "notice card") {
        text = add("p") { setAttribute("role", "status") }
        addIconButton("", Icon.CLOSE, "Close") {
            cancel()
            hide()
        }
        classList.add("is-empty")
    }

    /** Shows [sentences] for 4 s, and 80 ms more for each character; nothing if all are empty. */
    fun say(vararg sentences: String) {
        val said = sentences.joinToString(" ")
        if (said.isEmpty()) return
        display(said) {}
        timer = window.setTimeout(::hide, FIRST + said.length * PER_LETTER)
    }

    /** Shows [sentence] with a button [label] that calls [choose]. */
    fun offer(sentence: String, label: String, choose: () -> Unit) {
        display(sentence) {}
        addChoice(label, choose)
        timer = window.setTimeout(::hide, FIRST + sentence.length * PER_LETTER)
    }

    /** Shows [progress] until the next sentence, unless a question waits for its answer. Closing it calls [onCancel]. */
    fun show(progress: String, onCancel: () -> Unit) {
        if (!isAsking) display(progress, onCancel)
    }

    /** Hides the progress. */
    fun endProgress() {
        if (!isAsking) hide()
    }

    /** Shows [question]; each of [choices] is a button. */
    fun ask(question: String, vararg choices: Pair<String, () -> Unit>) {
        display(question) {}
        isAsking = true
        for ((label, choose) in choices) addChoice(label, choose)
    }

    private fun addChoice(label: String, choose: () -> Unit) {
        text.addButton("", label) {
            hide()
            choose()
        }
    }

    private fun display(sentence: String, onCancel: () -> Unit) {
        isAsking = false
        cancel = onCancel
        text.showText(sentence)
        element.classList.remove("is-empty")
        window.clearTimeout(timer)
    }

    /** Hides the sentence, the progress or the question, without calling anything. */
    fun hide() {
        isAsking = false
        element.classList.add("is-empty")
        text.showText("")
    }
}

/** The milliseconds for which every sentence stays, and the additional ones for each character, for slow readers. */
private const val FIRST = 4000
private const val PER_LETTER = 80
