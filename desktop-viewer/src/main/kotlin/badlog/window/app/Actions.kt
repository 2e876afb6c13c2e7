package badlog.window.app

import badlog.core.analysis.EnabledSpan
import badlog.viewer.choices.board.Board
import badlog.viewer.input.KeyAction
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.finding.FoundInLog
import badlog.viewer.state.Action
import badlog.viewer.state.Shown
import badlog.viewer.state.StateCell
import badlog.viewer.state.Store
import badlog.viewer.state.ViewerState
import badlog.window.findings.LogFindings
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.log.LiveView

/** Lets actions change the state of the open log, see [Store]. Use it only on the window's thread. */
internal class Actions(
    private val current: CurrentRecording,
    private val view: AxisView,
    private val board: GraphBoard,
    private val findings: LogFindings,
    private val live: LiveView,
    private val requests: WindowRequests,
) {
    // Not yet in one place: each part of the state is a variable of the part of the window that had it first.
    private val cell = object : StateCell {
        override var state: ViewerState
            get() = ViewerState(view.place, board.history, findings.state.panel)
            set(value) {
                view.go { value.place }
                board.take(value.board)
                findings.change { copy(panel = value.findings) }
            }
    }

    private val shown = object : Shown {
        override val samples: CursorSteps get() = current.recording?.cursorSteps ?: CursorSteps(emptyList())
        override val enabled: List<EnabledSpan> get() = current.recording?.enabled.orEmpty()
        override val found: FoundInLog? get() = findings.state.list
        override val graphs: Board get() = board.state
        override val graph: Int? get() = board.current?.id
        override val newest: Double? get() = live.newest
    }

    private val store = Store(cell, shown, requests::perform)

    /** Lets [action] change the state; most need an open log. */
    fun send(action: Action) {
        if (current.recording != null || action == Action.Press(KeyAction.CURSOR_VALUES)) store.send(action)
    }

    /** Does what [key] means. */
    fun perform(key: KeyAction) = send(Action.Press(key))
}
