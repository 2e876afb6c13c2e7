package badlog.page.app

import badlog.core.analysis.EnabledSpan
import badlog.page.board.BoardKeys
import badlog.page.findings.FindingsSection
import badlog.page.view.Scene
import badlog.viewer.choices.board.Board
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.finding.FoundInLog
import badlog.viewer.state.Request
import badlog.viewer.state.Shown
import badlog.viewer.state.StateCell
import badlog.viewer.state.Store
import badlog.viewer.state.ViewerState

/** Returns the store of the page's state; [perform] does what only the page can do. */
internal fun pageStore(scene: Scene, findings: FindingsSection, keys: BoardKeys, perform: (Request) -> Unit): Store {
    // Not yet in one place: each part of the state is a variable of the part of the page that had it first.
    val cell = object : StateCell {
        override var state: ViewerState
            get() = ViewerState(scene.place.now, scene.board.history, findings.state)
            set(value) {
                findings.state = value.findings
                scene.place.change { value.place }
                scene.board.take(value.board)
            }
    }
    val shown = object : Shown {
        override val samples: CursorSteps get() = scene.place.samples
        override val enabled: List<EnabledSpan> get() = scene.enabled
        override val found: FoundInLog get() = findings.found
        override val graphs: Board get() = scene.board.now
        override val graph: Int? get() = keys.current
    }
    return Store(cell, shown, perform)
}
