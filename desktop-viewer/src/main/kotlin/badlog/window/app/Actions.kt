package badlog.window.app

import badlog.core.analysis.EnabledSpan
import badlog.viewer.input.Action
import badlog.viewer.session.Request
import badlog.viewer.session.Session
import badlog.viewer.session.Shown
import badlog.viewer.session.after
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.finding.FindingOrder
import badlog.window.findings.LogFindings
import badlog.window.formula.FormulaStore
import badlog.window.graph.SpokenCursor
import badlog.window.layout.KeptLayouts
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.log.LiveView
import badlog.window.log.LogNotes
import badlog.window.log.OpenRecording
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.WindowPanels
import badlog.window.video.LogVideo

/** Performs what keys do on an exported page as well, see [after]. Use it only on the window's thread. */
internal class Actions(
    private val current: CurrentRecording,
    private val view: AxisView,
    private val board: GraphBoard,
    private val formulas: FormulaStore,
    private val findings: LogFindings,
    private val notes: LogNotes,
    private val layouts: KeptLayouts,
    private val panels: WindowPanels,
    private val video: LogVideo,
    private val spoken: SpokenCursor,
    private val live: LiveView,
) {
    /** Performs [action]; most need an open log. */
    fun perform(action: Action) {
        val open = current.recording ?: return if (action == Action.CURSOR_VALUES) perform(Request.Values) else Unit
        val outcome = after(Session(view.place, board.history, board.state, board.current?.id), ShownRecording(open), action)
        view.go { outcome.session.place }
        board.take(outcome.session.board)
        outcome.request?.let(::perform)
    }

    private fun perform(request: Request) = when (request) {
        Request.Values -> panels.change { toggled(InspectorTab.CURSOR) }

        Request.Modules -> panels.change { toggled(InspectorTab.MODULES) }

        Request.Pin -> board.togglePin()

        is Request.Graph -> board.keepInSight(request.id)

        is Request.Layout -> layouts.step(request.steps)

        Request.Cursor -> spoken.sayValues()

        is Request.Finding -> {
            findings.showEvidence(request.step.place.finding)
            spoken.sayFinding(request.step.spoken)
            openFindings()
        }

        Request.NoFinding -> openFindings()

        Request.Formula -> formulas.write()

        is Request.Note -> if (notes.state.log != null) {
            panels.change { inspecting(InspectorTab.NOTES) }
            notes.write(request.x)
        } else {
            Unit
        }

        is Request.Mark -> notes.mark(request.x, spoken.placeOf(request.x))

        is Request.Frames -> video.step(request.count)
    }

    /** Shows what to look at next, unless a person reads another panel; in a narrow window, nothing is opened in front of the graphs. */
    private fun openFindings() = panels.change { if (inspector == null) copy(inspector = InspectorTab.FINDINGS) else this }

    private inner class ShownRecording(private val open: OpenRecording) : Shown {
        override val samples: CursorSteps get() = open.cursorSteps
        override val enabled: List<EnabledSpan> get() = open.enabled
        override val findings: FindingOrder? get() = this@Actions.findings.state.list?.order
        override val newest: Double? get() = live.newest
    }
}
