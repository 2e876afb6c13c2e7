package badlog.page.section

import badlog.page.formula.FormulaDialog
import badlog.page.view.Scene
import kotlinx.browser.document
import org.w3c.dom.Element
import org.w3c.dom.events.KeyboardEvent

/** The keys that work wherever nothing is being typed. */
internal class Keyboard(
    private val scene: Scene,
    private val zoomBar: ZoomBar,
    private val search: SearchBox,
    private val findings: FindingList,
    private val formulas: FormulaDialog,
    private val help: HelpOverlay,
) {
    init {
        document.addEventListener("keydown", { press(it.unsafeCast<KeyboardEvent>()) })
    }

    private fun press(event: KeyboardEvent) {
        if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event)) return
        val steps = if (event.shiftKey) MANY else 1
        when (event.key) {
            "ArrowLeft" -> step(-steps)
            "ArrowRight" -> step(steps)
            "+", "=" -> scene.range.change { zoomed(1, scene.cursor.x) }
            "-", "−" -> scene.range.change { zoomed(-1, scene.cursor.x) }
            "0", "Home" -> scene.range.change { reset() }
            "Backspace" -> scene.range.change { if (event.shiftKey) forward() else back() }
            "n", "N" -> findings.step(1)
            "p", "P" -> findings.step(-1)
            "f", "F" -> formulas.open()
            "/" -> search.focus()
            "?" -> help.toggle()
            "Escape" -> escape()
            else -> return
        }
        if (event.key != "Escape") event.preventDefault()
    }

    private fun step(count: Int) {
        val now = scene.range.now
        scene.cursor.step(count, (now.from + now.to) / 2)
        scene.range.change { revealing(scene.cursor.x) }
    }

    private fun escape() {
        search.clear()
        scene.cursor.place(Double.NaN)
    }

    private fun isTyping(event: KeyboardEvent): Boolean {
        val target = event.target.unsafeCast<Element?>() ?: return false
        return target.tagName in TYPING || (target.closest("dialog") != null && event.key != "?")
    }

    private companion object {
        const val MANY = 10
        val TYPING = setOf("INPUT", "SELECT", "TEXTAREA")
    }
}
