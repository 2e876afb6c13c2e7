package badlog.viewer.panel.finding

import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.rules.incident.nextOf
import badlog.viewer.panel.Button
import badlog.viewer.panel.Buttons
import badlog.viewer.panel.Line
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.PartIcon
import badlog.viewer.panel.Row
import badlog.viewer.panel.Rows
import badlog.viewer.panel.Tone
import badlog.viewer.shown.finding.firstPlace
import badlog.viewer.shown.finding.placeNumber
import badlog.viewer.shown.finding.placesInOrder
import badlog.viewer.state.Action
import badlog.viewer.state.FindingAction
import badlog.viewer.state.FindingRequest
import badlog.viewer.text.countText
import badlog.viewer.text.word

/** Returns [incidents] as rows, each with its findings in order and links to their places; null if there are none. */
internal fun incidentRows(shown: FindingsShown, incidents: List<Incident>): Rows? = if (incidents.isEmpty()) {
    null
} else {
    val keys = UniqueKeys()
    Rows("incidents", "Incidents", incidents.map { incidentRow(shown, it, keys.of("incident ${it.name}$SEPARATOR${it.time}")) })
}

private fun incidentRow(shown: FindingsShown, incident: Incident, key: String): Row {
    val current = shown.visited?.finding
    val sentences = incident.sentences
    val first = sentences.first().finding
    val read = sentences.map { it.finding }.find { it === current }
    return Row(
        key,
        incident.severity,
        "Incident: ${incident.name}",
        incident.name,
        sentences.map { lineOf(shown, it.finding, it.text, incident) },
        isFramed = true,
        isCurrent = current != null && current in incident,
        open = goTo(incident.first, incident, isWhole = true),
        tools = if (shown.details == null) listOf(pin(first, incident)) else emptyList(),
        below = if (read != null && shown.details != null) detailsOf(shown, read) else nextOf(incident.next),
    )
}

/** Returns [findings] as rows with severity, time, rule and text. */
internal fun findingRows(shown: FindingsShown, findings: List<Finding>): List<Row> {
    val keys = UniqueKeys()
    return findings.map { findingRow(shown, it, keys.of("finding ${it.rule}$SEPARATOR${it.topic}")) }
}

private fun findingRow(shown: FindingsShown, finding: Finding, key: String): Row {
    val isCurrent = finding === shown.visited?.finding
    val incident = shown.found?.incidentOf(finding)
    val isRepeated = finding.spanCount > 1 && "${finding.spanCount}" !in finding.text
    return Row(
        key,
        finding.severity,
        "Finding, ${finding.severity.word}: ${finding.rule}",
        finding.rule,
        listOf(lineOf(shown, finding, finding.text, incident = null)),
        count = if (isRepeated) "${countText(finding.spanCount)} times" else "",
        isCurrent = isCurrent,
        open = goTo(finding, incident, isWhole = false),
        tools = if (finding.evidence.isEmpty() || shown.details != null) emptyList() else listOf(pin(finding, incident)),
        menu = shown.todo?.buttonsOf(finding).orEmpty(),
        below = if (isCurrent && shown.details != null) detailsOf(shown, finding) else shown.todo?.linesOf(finding).orEmpty(),
    )
}

private fun lineOf(shown: FindingsShown, finding: Finding, text: String, incident: Incident?): Line {
    val isPlaced = finding.time.isFinite()
    val end = finding.spans.firstOrNull()?.to ?: finding.time
    return Line(
        text,
        time = if (isPlaced) shown.times.logged(finding.time) else "whole log",
        until = if (incident == null && end > finding.time) shown.times.logged(end) else "",
        since = shown.times.sinceEnabled(finding.time),
        name = if (incident == null) "" else "Finding, ${finding.severity.word}: ${finding.rule}",
        open = goTo(finding, incident, isWhole = false),
        hint = if (isPlaced) "Zoom to it" else "Show its graphs",
        isCurrent = finding === shown.visited?.finding,
    )
}

private fun goTo(finding: Finding, incident: Incident?, isWhole: Boolean): Action =
    FindingAction.GoTo(finding.firstPlace, incident, isWhole)

private fun pin(finding: Finding, incident: Incident?) =
    Button("Add its graphs to the board", Action.Ask(FindingRequest.Pin(finding, incident)), PartIcon.PIN)

/** Returns the hint [next] as a part; no part if it is empty. */
internal fun nextOf(next: String): List<Part> =
    if (next.isEmpty()) emptyList() else listOf(Paragraph("incident-next", "Next: $next", Tone.MUTED))

/** Makes unique keys for rows: a hook may report the same finding twice. */
private class UniqueKeys {
    private val times = HashMap<String, Int>()

    /** Returns [name], or [name] with a number if it was returned before. */
    fun of(name: String): String {
        val before = times[name] ?: 0
        times[name] = before + 1
        return if (before == 0) name else "$name$SEPARATOR$before"
    }
}

/** A character that never occurs in the name of a rule or topic. */
private const val SEPARATOR = '\u0000'

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
