package badlog.page.app

import badlog.page.findings.SignalChoice
import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.viewer.state.FindingRequest

/**
 * Performs the requests of actions that concern findings.
 *
 * @param onShow shows the evidence of a finding.
 * @param onPin adds the graphs of a finding to the board.
 */
internal class FindingRequests(
    private val signals: SignalChoice,
    private val changes: LogChanges,
    private val live: LiveRegion,
    private val onShow: (FindingRequest.Show) -> Unit,
    private val onPin: (Finding, Incident?) -> Unit,
) {
    /** Performs [request]. */
    fun perform(request: FindingRequest) = when (request) {
        is FindingRequest.Show -> {
            onShow(request)
            request.spoken?.let(live::announceFinding) ?: Unit
        }

        FindingRequest.AnnounceNone -> live.announce("No finding to go to.")

        is FindingRequest.Pin -> onPin(request.finding, request.incident)

        is FindingRequest.Compare -> changes.draw(request.difference)

        is FindingRequest.Assign -> signals.assign(request.signal, request.topic)

        is FindingRequest.Forget -> signals.forget(request.signal)

        FindingRequest.SaveSignals -> signals.save()

        // The evidence has its own buttons, and the rules of a page are fixed.
        FindingRequest.Keep, is FindingRequest.Add, FindingRequest.RunRules -> Unit
    }
}
