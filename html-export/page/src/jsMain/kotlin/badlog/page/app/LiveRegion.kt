package badlog.page.app

import badlog.core.analysis.GraphSeries
import badlog.page.dom.PageEvents
import badlog.page.dom.element
import badlog.page.dom.showText
import badlog.page.findings.EvidenceSection
import badlog.page.header.SearchBox
import badlog.page.panel.HelpOverlay
import badlog.page.view.Scene
import badlog.viewer.input.KeyAction
import badlog.viewer.shown.cursor.spokenAt
import badlog.viewer.state.Action
import badlog.viewer.state.PlaceAction
import kotlinx.browser.document
import org.w3c.dom.Element
import org.w3c.dom.HTMLElement
import org.w3c.dom.events.KeyboardEvent

/** Announces cursor moves by keys, and the values there, to screen readers only. */
internal class LiveRegion(private val scene: Scene, private val lines: () -> List<GraphSeries>) {
    val element: HTMLElement = element("div", "spoken") {
        id = "spoken"
        setAttribute("role", "status")
    }

    /** Announces the position of the cursor that keys move, and the values there. */
    fun announceCursor() {
        val x = scene.cursor.now.moving ?: return
        element.showText(spokenAt(lines(), x, scene.xText(x)))
    }

    /** Announces [text]; it replaces a text that screen readers have not read yet. */
    fun announce(text: String) = element.showText(text)

    /** Announces [found], the finding at the cursor. */
    fun announceFinding(found: String) {
        val x = scene.cursor.now.pinned ?: return
        if (found.isNotEmpty()) element.showText("${scene.xText(x)}: $found")
    }
}

/** The keyboard shortcuts of the page, active unless text is being typed. */
internal class Keyboard(
    private val search: SearchBox,
    private val evidence: EvidenceSection,
    private val help: HelpOverlay,
    private val send: (Action) -> Unit,
) {
    init {
        PageEvents.on(document, "keydown") { press(it.unsafeCast<KeyboardEvent>()) }
    }

    private fun press(event: KeyboardEvent) {
        if (isTyping(event)) return
        val ctrl = event.ctrlKey || event.metaKey
        val isPlain = !ctrl && !event.altKey
        when {
            isPlain && event.key == "/" -> search.focus()

            isPlain && event.key == "?" -> help.toggle()

            isPlain && event.key == "Escape" -> escape()

            else -> {
                val key = KeyAction.of(LABELS[event.key] ?: event.key.uppercaseLetter(), event.shiftKey, ctrl, event.altKey) ?: return
                send(Action.Press(key))
            }
        }
        if (event.key != "Escape") event.preventDefault()
    }

    private fun String.uppercaseLetter() = if (length == 1) uppercase() else this

    private fun escape() = when {
        search.text.isNotEmpty() -> search.clear()
        evidence.isOpen -> evidence.close()
        else -> send(PlaceAction.Cancel)
    }

    private fun isTyping(event: KeyboardEvent): Boolean {
        val target = event.target.unsafeCast<Element?>() ?: return false
        return target.tagName in TYPING || (target.closest("dialog") != null && event.key != "?")
    }

    private companion object {
        /** The labels of keys for which browsers use other names. */
        val LABELS = mapOf("ArrowLeft" to "←", "ArrowRight" to "→", "ArrowUp" to "↑", "ArrowDown" to "↓", "=" to "+", "−" to "-")
        val TYPING = setOf("INPUT", "SELECT", "TEXTAREA")
    }
}
