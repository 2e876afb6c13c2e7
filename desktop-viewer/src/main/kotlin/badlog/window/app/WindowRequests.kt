package badlog.window.app

import badlog.viewer.state.CompareRequest
import badlog.viewer.state.FindingRequest
import badlog.viewer.state.FolderRequest
import badlog.viewer.state.Request
import badlog.window.battery.FolderSeason
import badlog.window.compare.ComparedRecordings
import badlog.window.formula.FormulaStore
import badlog.window.graph.SpokenCursor
import badlog.window.layout.KeptLayouts
import badlog.window.log.GraphBoard
import badlog.window.log.LogNotes
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.MainView
import badlog.window.sidebar.WindowPanels
import badlog.window.todo.FolderTodo
import badlog.window.video.LogVideo

/** Performs the requests of actions to the window. Use it only on the window's thread. */
internal class WindowRequests(
    private val board: GraphBoard,
    private val formulas: FormulaStore,
    private val findings: FindingRequests,
    private val compared: ComparedRecordings,
    private val notes: LogNotes,
    private val layouts: KeptLayouts,
    private val panels: WindowPanels,
    private val video: LogVideo,
    private val spoken: SpokenCursor,
    private val todo: FolderTodo,
    private val batteries: FolderSeason,
) {
    /** Performs [request]. */
    fun perform(request: Request) = when (request) {
        is FindingRequest -> findings.perform(request)

        // The list of logs has check boxes.
        CompareRequest.Choose -> panels.change { copy(library = true) }

        is CompareRequest -> compared.perform(request)

        is FolderRequest.Fill -> panels.change { copy(form = request.form) }

        FolderRequest.Batteries -> panels.change { toggled(MainView.BATTERIES) }

        FolderRequest.Todo -> panels.change { toggled(MainView.TODO) }

        // Only the list's own pane can reach the clipboard.
        FolderRequest.CopyTodo -> Unit

        FolderRequest.SaveTodo -> todo.savePage()

        is FolderRequest.UseBattery -> batteries.assign(request.battery, request.match)

        is FolderRequest.WriteTodo -> todo.perform(request)

        is Request.ChangeNote -> notes.rewrite(request.note)

        is Request.RemoveNote -> notes.remove(request.note, spoken.placeOf(request.note.x))

        Request.Values -> panels.change { toggled(InspectorTab.CURSOR) }

        Request.Modules -> panels.change { toggled(InspectorTab.MODULES) }

        Request.Pin -> board.togglePin()

        is Request.Graphs -> board.follow(request)

        is Request.Layout -> layouts.step(request.steps)

        Request.Cursor -> spoken.sayValues()

        Request.Formula -> formulas.write()

        is Request.Note -> write(request)

        is Request.Mark -> notes.mark(request.x, spoken.placeOf(request.x))

        is Request.Frames -> video.step(request.count)
    }

    private fun write(request: Request.Note) {
        if (notes.state.log == null) return
        panels.change { inspecting(InspectorTab.NOTES) }
        notes.write(request.x)
    }
}
