package badlog.page.app

import badlog.core.analysis.EnabledSpan
import badlog.page.board.BoardKeys
import badlog.page.findings.FindingsSection
import badlog.page.view.Scene
import badlog.viewer.choices.board.Board
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.finding.RuleResults
import badlog.viewer.state.Shown

/** The content of the page's log. The parts of the page are passed as functions, because they may not exist yet. */
internal class PageShown(private val scene: () -> Scene, private val findings: () -> FindingsSection, private val keys: () -> BoardKeys) :
    Shown {
    override val samples: CursorSteps by lazy { CursorSteps(scene().xAxis.clocks) }
    override val enabled: List<EnabledSpan> get() = scene().enabled
    override val found: RuleResults get() = findings().found
    override val graphs: Board get() = scene().board.now
    override val graph: Int? get() = keys().current
}
