package badlog.page.app

import badlog.page.board.BoardKeys
import badlog.page.compare.CompareBar
import badlog.page.formula.FormulaDialog
import badlog.page.layout.LayoutDialog
import badlog.page.note.NoteDialog
import badlog.page.panel.CursorPanel
import badlog.page.panel.ModulesPanel
import badlog.page.video.VideoPanel
import badlog.viewer.state.CompareRequest
import badlog.viewer.state.FindingRequest
import badlog.viewer.state.FolderRequest
import badlog.viewer.state.Request

/** Carries out the requests that actions make to the page. */
internal class PageRequests(
    private val board: BoardKeys,
    private val values: CursorPanel,
    private val modules: ModulesPanel,
    private val formulas: FormulaDialog,
    private val notes: NoteDialog,
    private val layouts: LayoutDialog,
    private val video: VideoPanel,
    private val compared: CompareBar,
    private val live: LiveRegion,
    private val onFinding: (FindingRequest) -> Unit,
) {
    /** Carries out [request]. */
    fun perform(request: Request): Unit = when (request) {
        is FindingRequest -> onFinding(request)

        is CompareRequest -> compared.perform(request)

        // A page cannot write beside the logs, so it has no team's list.
        is FolderRequest -> Unit

        is Request.ChangeNote -> notes.edit(request.note)

        is Request.RemoveNote -> notes.remove(request.note)

        Request.Values -> values.toggle()

        Request.Modules -> modules.toggle()

        Request.Pin -> board.togglePin()

        is Request.Graphs -> board.follow(request)

        is Request.Layout -> layouts.step(request.steps)

        Request.Cursor -> live.announceCursor()

        Request.Formula -> formulas.open()

        is Request.Note -> notes.write(request.x)

        is Request.Mark -> notes.mark(request.x)

        is Request.Frames -> video.step(request.count)
    }
}
