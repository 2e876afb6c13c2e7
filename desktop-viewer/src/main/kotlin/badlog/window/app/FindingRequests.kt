package badlog.window.app

import badlog.viewer.choices.board.with
import badlog.viewer.state.FindingRequest
import badlog.window.compare.ComparedRecordings
import badlog.window.findings.CurrentFindings
import badlog.window.folder.SinceLastMatch
import badlog.window.graph.SpokenCursor
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.sidebar.FrontPart
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.WindowPanels

/** Performs the requests of actions about findings. Use it only on the window's thread. */
internal class FindingRequests(
    private val current: CurrentRecording,
    private val findings: CurrentFindings,
    private val board: GraphBoard,
    private val compared: ComparedRecordings,
    private val since: SinceLastMatch,
    private val panels: WindowPanels,
    private val spoken: SpokenCursor,
) {
    /** Performs [request]; a request that only a page can perform has no effect. */
    fun perform(request: FindingRequest) = when (request) {
        is FindingRequest.Show -> show(request)

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

    private fun show(request: FindingRequest.Show) {
        findings.showEvidence(request.place.finding)
        spoken.sayFinding(request.spoken ?: return)
        openPanel()
    }

    /** Opens the findings if no other panel is open; in a narrow window, the graphs stay in front. */
    private fun openPanel() = panels.change { if (inspector == null) copy(inspector = InspectorTab.FINDINGS) else this }

    private fun pin(request: FindingRequest.Pin) {
        findings.showEvidence(request.finding)
        board.keep()
    }

    private fun add(request: FindingRequest.Add) {
        val open = current.recording ?: return
        board.showEvidence(board.evidence.with(request.offer, open.view, open.vocabulary))
    }

    private fun compare(request: FindingRequest.Compare) {
        findings.showEvidence(request.difference)
        since.state.previous[request.difference]?.file?.takeIf { it !in compared.state.checked }?.let(compared::add)
        panels.change { copy(front = FrontPart.GRAPHS) }
    }
}
