package badlog.page.opened

import badlog.core.recording.Severity
import badlog.page.dom.ResizeObserver
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.screenKey
import badlog.viewer.input.ScreenKey
import badlog.viewer.shown.folder.Arrivals
import badlog.viewer.shown.folder.arrivalText
import badlog.viewer.text.word
import kotlinx.browser.document
import org.w3c.dom.HTMLElement
import org.w3c.dom.events.Event
import org.w3c.dom.events.FocusEvent
import org.w3c.dom.events.KeyboardEvent

/**
 * The announcement of a new log and its worst finding. It is at the lower edge of every screen, until a person shows or postpones the log.
 *
 * @param onShow called to show that log.
 * @param onLater called to postpone it.
 */
internal class ArrivalBar(private val onShow: () -> Unit, onLater: () -> Unit) {
    private lateinit var text: HTMLElement
    private val element = element("aside", "arrival is-empty") {
        setAttribute("aria-label", "New log")
        // Screen readers announce text that appears in an existing element.
        text = add("p") { setAttribute("role", "status") }
        addButton("", "Show", "Show the new log, at its worst finding (A)", onShow).id = "show-arrival"
        addButton("", "Later", "Hide this; the log stays in the list") {
            onLater()
            // The button is gone, and with it the keyboard's focus.
            (before?.takeIf { it.isConnected } ?: document.getElementById("go-back"))?.unsafeCast<HTMLElement>()?.focus()
        }.id = "leave-arrival"
        addEventListener("focusin", {
            val from = it.unsafeCast<FocusEvent>().relatedTarget?.unsafeCast<HTMLElement>()
            if (from?.closest(".arrival") == null) before = from
        })
    }
    private var before: HTMLElement? = null
    private val size = ResizeObserver { page.style.setProperty(HEIGHT, "${element.offsetHeight}px") }
    private val press = { event: Event -> press(event.unsafeCast<KeyboardEvent>()) }

    /** Adds the bar to the page, still hidden. */
    fun start() {
        document.body?.appendChild(element)
        size.observe(element)
        document.addEventListener("keydown", press)
    }

    /** Removes the bar from the page. */
    fun stop() {
        element.remove()
        size.disconnect()
        page.style.removeProperty(HEIGHT)
        document.removeEventListener("keydown", press)
    }

    /** Shows the latest of [arrivals], or hides the bar. */
    fun show(arrivals: Arrivals<OpenedLog>) {
        val match = arrivals.latest
        val log = match?.worst
        val severity = log?.found?.verdict?.severity ?: Severity.NOTE
        element.className = if (log == null) "arrival is-empty" else "arrival is-${severity.word}"
        say(log?.title.orEmpty(), if (match == null || log == null) "" else arrivalText(log, arrivals.waiting.size - match.logs.size))
    }

    /** Shows [sentence], which begins with [title]. The title may be written from right to left. */
    private fun say(title: String, sentence: String) {
        if (text.textContent == sentence) return
        text.textContent = ""
        text.add("bdi", "", title)
        text.add("span", "", sentence.removePrefix(title))
    }

    private fun press(event: KeyboardEvent) {
        if (event.screenKey != ScreenKey.NEW_LOG || element.classList.contains("is-empty")) return
        event.preventDefault()
        onShow()
    }

    private companion object {
        /** The CSS property with the height of the bar, for which the rest of the page leaves room. */
        const val HEIGHT = "--arrival"
        val page: HTMLElement get() = document.documentElement.unsafeCast<HTMLElement>()
    }
}
