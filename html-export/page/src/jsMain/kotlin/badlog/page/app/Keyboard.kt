package badlog.page.app

import badlog.page.board.BoardKeys
import badlog.page.dom.PageEvents
import badlog.page.findings.EvidenceSection
import badlog.page.findings.FindingList
import badlog.page.formula.FormulaDialog
import badlog.page.header.SearchBox
import badlog.page.note.NoteDialog
import badlog.page.panel.CursorPanel
import badlog.page.panel.HelpOverlay
import badlog.page.video.VideoPanel
import badlog.page.view.Scene
import badlog.viewer.input.Action
import badlog.viewer.shown.cursor.Cursors
import kotlinx.browser.document
import org.w3c.dom.Element
import org.w3c.dom.events.KeyboardEvent

/** The keys that work wherever nothing is being typed. */
internal class Keyboard(
    private val scene: Scene,
    private val search: SearchBox,
    private val findings: FindingList,
    private val evidence: EvidenceSection,
    private val board: BoardKeys,
    private val values: CursorPanel,
    private val formulas: FormulaDialog,
    private val notes: NoteDialog,
    private val help: HelpOverlay,
    private val video: VideoPanel,
    private val live: LiveRegion,
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
            else -> perform(Action.of(LABELS[event.key] ?: event.key.uppercaseLetter(), event.shiftKey, ctrl, event.altKey) ?: return)
        }
        if (event.key != "Escape") event.preventDefault()
    }

    private fun String.uppercaseLetter() = if (length == 1) uppercase() else this

    private fun perform(action: Action) = when (action) {
        Action.PREVIOUS_SAMPLE -> step(-1)
        Action.NEXT_SAMPLE -> step(1)
        Action.TEN_SAMPLES_BACK -> step(-Action.MANY_SAMPLES)
        Action.TEN_SAMPLES_ON -> step(Action.MANY_SAMPLES)
        Action.SECOND_CURSOR -> scene.cursor.change { withSecond() }
        Action.ZOOM_IN -> scene.range.change { zoomed(1, scene.cursor.x) }
        Action.ZOOM_OUT -> scene.range.change { zoomed(-1, scene.cursor.x) }
        Action.SHOW_ALL -> scene.range.change { reset() }
        Action.PREVIOUS_VIEW -> scene.range.change { back() }
        Action.NEXT_VIEW -> scene.range.change { forward() }
        Action.SHOW_ENABLED -> scene.range.change { showingEnabled(scene.enabled) }
        Action.PAN_LEFT -> scene.range.change { panned(-Action.PAN_SHARE) }
        Action.PAN_RIGHT -> scene.range.change { panned(Action.PAN_SHARE) }
        Action.CURSOR_VALUES -> values.toggle()
        Action.NEW_FORMULA -> formulas.open()
        Action.NEW_NOTE -> notes.write()
        Action.NEXT_FINDING -> goToFinding(1)
        Action.PREVIOUS_FINDING -> goToFinding(-1)
        Action.PREVIOUS_FRAME -> video.step(-1)
        Action.NEXT_FRAME -> video.step(1)
        Action.PIN, Action.MOVE_UP, Action.MOVE_DOWN, Action.NEXT_HEIGHT, Action.UNDO, Action.REDO -> board.perform(action)
    }

    private fun step(count: Int) {
        val now = scene.range.now
        scene.cursor.step(count, (now.from + now.to) / 2)
        scene.cursor.now.moving?.let { scene.range.change { revealing(it) } }
        live.tellCursor()
    }

    private fun goToFinding(steps: Int) = live.tellFinding(findings.step(steps))

    private fun escape() {
        search.clear()
        evidence.close()
        scene.cursor.change { Cursors() }
    }

    private fun isTyping(event: KeyboardEvent): Boolean {
        val target = event.target.unsafeCast<Element?>() ?: return false
        return target.tagName in TYPING || (target.closest("dialog") != null && event.key != "?")
    }

    private companion object {
        /** The labels of keys that have other names in browsers. */
        val LABELS = mapOf("ArrowLeft" to "←", "ArrowRight" to "→", "ArrowUp" to "↑", "ArrowDown" to "↓", "=" to "+", "−" to "-")
        val TYPING = setOf("INPUT", "SELECT", "TEXTAREA")
    }
}
