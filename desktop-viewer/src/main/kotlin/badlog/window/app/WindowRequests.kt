package badlog.window.app

import badlog.viewer.choices.board.with
import badlog.viewer.state.CompareRequest
import badlog.viewer.state.FindingRequest
import badlog.viewer.state.FolderRequest
import badlog.viewer.state.Request
import badlog.window.export.figure.copyText
import badlog.window.sidebar.FrontPart
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.MainView

/** Performs [request], which an action makes to the window. Call it only on the window's thread. */
internal fun Viewer.perform(request: Request) = when (request) {
    is FindingRequest -> perform(request)

    // The list of logs has check boxes.
    CompareRequest.Choose -> panels.change { copy(library = true, front = FrontPart.LOGS) }

    is CompareRequest -> compared.perform(request)

    is FolderRequest.Fill -> panels.change { copy(form = request.form) }

    FolderRequest.Batteries -> panels.change { toggled(MainView.BATTERIES) }

    FolderRequest.Todo -> panels.change { toggled(MainView.TODO) }

    FolderRequest.SaveTodo -> todo.savePage()

    is FolderRequest.UseBattery -> batteries.assign(request.battery, request.match)

    is FolderRequest.WriteTodo -> todo.perform(request)

    is Request.ChangeNote -> notes.rewrite(request.note)

    is Request.RemoveNote -> notes.remove(request.note, spoken.placeOf(request.note.x))

    is Request.Copy -> copy(request.text())

    Request.Values -> panels.change { toggled(InspectorTab.CURSOR) }

    Request.Modules -> panels.change { toggled(InspectorTab.MODULES) }

    Request.Pin -> board.togglePin()

    is Request.Graphs -> board.follow(request)

    is Request.Layout -> keptLayouts.step(request.steps)

    Request.Cursor -> spoken.sayValues()

    Request.Formula -> formulas.write()

    is Request.Note -> write(request)

    is Request.Mark -> notes.mark(request.x, spoken.placeOf(request.x))

    is Request.Frames -> video.step(request.count)
}

private fun Viewer.copy(text: String) {
    tasks.run("Copying the text", { copyText(text) }) {}
}

private fun Viewer.write(request: Request.Note) {
    if (notes.state.log == null) return
    panels.change { inspecting(InspectorTab.NOTES) }
    notes.write(request.x)
}

/** Performs [request]; a request that only a page can perform has no effect. */
private fun Viewer.perform(request: FindingRequest) = when (request) {
    is FindingRequest.Show -> showEvidence(request)

    FindingRequest.AnnounceNone -> openPanel()

    is FindingRequest.Pin -> pin(request)

    FindingRequest.Keep -> board.keep()

    is FindingRequest.Add -> add(request)

    is FindingRequest.Compare -> compare(request)

    FindingRequest.RunRules -> findings.runAgain()

    is FindingRequest.Assign -> findings.assign(request.signal, request.topic)

    // A person edits the folder's file of signals instead.
    is FindingRequest.Forget, FindingRequest.SaveSignals -> Unit
}

private fun Viewer.showEvidence(request: FindingRequest.Show) {
    findings.showEvidence(request.place.finding)
    spoken.sayFinding(request.spoken ?: return)
    openPanel()
}

/** Opens the findings if no other panel is open; in a narrow window, the graphs stay in front. */
private fun Viewer.openPanel() = panels.change { if (inspector == null) copy(inspector = InspectorTab.FINDINGS) else this }

private fun Viewer.pin(request: FindingRequest.Pin) {
    findings.showEvidence(request.finding)
    board.keep()
}

private fun Viewer.add(request: FindingRequest.Add) {
    val open = current.recording ?: return
    board.showEvidence(board.evidence.with(request.offer, open.view, open.vocabulary))
}

private fun Viewer.compare(request: FindingRequest.Compare) {
    findings.showEvidence(request.difference)
    since.state.previous[request.difference]?.file?.takeIf { it !in compared.state.checked }?.let(compared::add)
    panels.change { copy(front = FrontPart.GRAPHS) }
}
