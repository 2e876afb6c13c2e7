package badlog.page.app

import badlog.core.analysis.EnabledSpan
import badlog.page.board.BoardKeys
import badlog.page.dom.PageEvents
import badlog.page.findings.EvidenceSection
import badlog.page.findings.FindingList
import badlog.page.formula.FormulaDialog
import badlog.page.header.SearchBox
import badlog.page.layout.LayoutDialog
import badlog.page.note.NoteDialog
import badlog.page.panel.CursorPanel
import badlog.page.panel.HelpOverlay
import badlog.page.panel.ModulesPanel
import badlog.page.video.VideoPanel
import badlog.page.view.Scene
import badlog.viewer.input.Action
import badlog.viewer.session.Request
import badlog.viewer.session.Session
import badlog.viewer.session.Shown
import badlog.viewer.session.after
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.finding.FindingOrder
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
    private val modules: ModulesPanel,
    private val formulas: FormulaDialog,
    private val notes: NoteDialog,
    private val layouts: LayoutDialog,
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

    private fun perform(action: Action) {
        val outcome = after(Session(scene.place.now, scene.board.history, scene.board.now, board.current), shown, action)
        scene.place.change { outcome.session.place }
        scene.board.take(outcome.session.board)
        outcome.request?.let(::perform)
    }

    private fun perform(request: Request) = when (request) {
        Request.Values -> values.toggle()

        Request.Modules -> modules.toggle()

        Request.Pin -> board.togglePin()

        is Request.Graph -> board.keepInSight(request.id)

        is Request.Layout -> layouts.step(request.steps)

        Request.Cursor -> live.announceCursor()

        is Request.Finding -> with(request.step) {
            findings.show(place, incident, isWhole = incident != null)
            live.announceFinding(spoken)
        }

        Request.NoFinding -> live.announce("No finding to go to.")

        Request.Formula -> formulas.open()

        is Request.Note -> notes.write(request.x)

        is Request.Mark -> notes.mark(request.x)

        is Request.Frames -> video.step(request.count)
    }

    private val shown = object : Shown {
        override val samples: CursorSteps get() = scene.place.samples
        override val enabled: List<EnabledSpan> get() = scene.enabled
        override val findings: FindingOrder get() = this@Keyboard.findings.order
    }

    private fun escape() = when {
        search.text.isNotEmpty() -> search.clear()
        evidence.isOpen -> evidence.close()
        else -> scene.place.change { cancelled() }
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
