package badlog.viewer.panel.finding

import badlog.rules.Finding
import badlog.rules.incident.nextOf
import badlog.viewer.panel.Button
import badlog.viewer.panel.Buttons
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.PartIcon
import badlog.viewer.panel.Tone
import badlog.viewer.shown.finding.placeNumber
import badlog.viewer.shown.finding.placesInOrder
import badlog.viewer.state.Action
import badlog.viewer.state.FindingAction
import badlog.viewer.state.FindingRequest

/**
 * Returns the parts below the visited [finding]. They are its to-do item, its places, the next thing to look at, its caveats and other
 * graphs to show.
 */
internal fun detailsOf(shown: FindingsShown, finding: Finding): List<Part> {
    val details = checkNotNull(shown.details)
    return shown.todo?.linesOf(finding).orEmpty() +
        places(shown, finding) +
        nextOf(shown.found?.incidentOf(finding).nextOf(finding)) +
        finding.caveats.mapIndexed { i, caveat -> Paragraph("caveat $i", caveat, Tone.MUTED) } +
        listOfNotNull(graphs(details), shown.todo?.let { Buttons("to-do", it.buttonsOf(finding)) })
}

private fun places(shown: FindingsShown, finding: Finding): List<Part> {
    val places = finding.placesInOrder
    if (places.size < 2) return emptyList()
    val index = maxOf(0, places.indexOfFirst { it.from == shown.visited?.span?.from })
    val number = "${finding.placeNumber(places[index])}: ${shown.times.logged(places[index].from)}"
    return listOf(
        Buttons(
            "places",
            listOf(
                Button("Previous place", FindingAction.StepWithin(-1), PartIcon.PREVIOUS, isEnabled = index > 0),
                Button("Next place", FindingAction.StepWithin(1), PartIcon.NEXT, isEnabled = index < places.lastIndex),
            ),
        ),
        Paragraph("place number", number, Tone.MUTED),
        Paragraph("place", finding.textAt(places[index])),
    )
}

private fun graphs(details: FindingDetails): Part? {
    val keep = Button("Keep", Action.Ask(FindingRequest.Keep), PartIcon.PIN, "Keep the graphs of this finding on the board")
    val offers = details.offers.map {
        Button(it.label, Action.Ask(FindingRequest.Add(it)), PartIcon.ADD, "Show ${it.label.lowercase()} beside this finding")
    }
    val buttons = (if (details.hasGraphs) listOf(keep) else emptyList()) + offers
    return if (buttons.isEmpty()) null else Buttons("graphs", buttons)
}
