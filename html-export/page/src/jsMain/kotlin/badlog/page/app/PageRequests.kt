package badlog.page.app

import badlog.page.dom.copyText
import badlog.viewer.state.CompareRequest
import badlog.viewer.state.FindingRequest
import badlog.viewer.state.FolderRequest
import badlog.viewer.state.Request

/** Performs [request], which an action makes to the page. */
internal fun LogPage.perform(request: Request): Unit = when (request) {
    is FindingRequest -> perform(request)

    is CompareRequest -> compareBar.perform(request)

    // A page cannot write beside the logs, so it has no team's list.
    is FolderRequest -> Unit

    is Request.ChangeNote -> noteDialog.edit(request.note)

    is Request.RemoveNote -> noteDialog.remove(request.note)

    is Request.Copy -> copyText(request.text()).unsafeCast<Unit>()

    Request.Values -> values.toggle()

    Request.Modules -> modules.toggle()

    Request.Pin -> keys.togglePin()

    is Request.Graphs -> keys.follow(request)

    is Request.Layout -> layouts.dialog.step(request.steps)

    Request.Cursor -> live.announceCursor()

    Request.Formula -> formulaDialog.open()

    is Request.Note -> noteDialog.write(request.x)

    is Request.Mark -> noteDialog.mark(request.x)

    is Request.Frames -> video.step(request.count)
}

private fun LogPage.perform(request: FindingRequest) = when (request) {
    is FindingRequest.Show -> {
        showEvidence(request)
        request.spoken?.let(live::announceFinding) ?: Unit
    }

    FindingRequest.AnnounceNone -> live.announce("No finding to go to.")

    is FindingRequest.Pin -> pinEvidence(request.finding, request.incident)

    is FindingRequest.Compare -> changes.draw(request.difference)

    is FindingRequest.Assign -> signalChoice.assign(request.signal, request.topic)

    is FindingRequest.Forget -> signalChoice.forget(request.signal)

    FindingRequest.SaveSignals -> signalChoice.save()

    // The evidence has its own buttons, and the rules of a page are fixed.
    FindingRequest.Keep, is FindingRequest.Add, FindingRequest.RunRules -> Unit
}
