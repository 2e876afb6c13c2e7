package badlog.viewer.panel.finding

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.rules.SkippedRule
import badlog.rules.incident.Incident
import badlog.signals.logging.LoggingLibrary
import badlog.signals.logging.howToLog
import badlog.signals.logging.isOfDriverStation
import badlog.viewer.input.KeyAction
import badlog.viewer.panel.Button
import badlog.viewer.panel.Buttons
import badlog.viewer.panel.Choice
import badlog.viewer.panel.Code
import badlog.viewer.panel.Field
import badlog.viewer.panel.Fold
import badlog.viewer.panel.Heading
import badlog.viewer.panel.Offers
import badlog.viewer.panel.PanelRoom
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.PartIcon
import badlog.viewer.panel.Rows
import badlog.viewer.panel.Tone
import badlog.viewer.panel.Trouble
import badlog.viewer.shown.finding.RuleResults
import badlog.viewer.shown.finding.SearchedFindings
import badlog.viewer.shown.folder.Changes
import badlog.viewer.state.Action
import badlog.viewer.state.FEW_FINDINGS
import badlog.viewer.state.FINDINGS_AT_A_TIME
import badlog.viewer.state.FindingAction
import badlog.viewer.state.FindingRequest
import badlog.viewer.text.countText

/**
 * Returns the panel of findings: the incidents, the other findings, the worst first, and the rules that could not run. Empty if there is
 * nothing to show.
 */
fun findingsPanel(shown: FindingsShown): List<Part> {
    val found = shown.found ?: return if (shown.isRunning) listOf(Heading(TITLE, RUNNING)) else emptyList()
    if (found.all.isEmpty() && found.ran == null && found.trouble == null && !shown.isRunning) return emptyList()
    val searched = found.foundBy(shown.state.query)
    val listed = listedFindings(shown, searched)
    val isLong = shown.room != PanelRoom.WHOLE && shown.state.listed != null && listed.findings.isNotEmpty()
    return listOfNotNull(
        heading(shown, found, searched),
        rulesLine(shown, found),
        search(shown, found),
        hidden(searched),
        shown.state.refusal?.let { Paragraph("refusal", it, Tone.ALERT) },
        changes(shown.differences),
    ) + troubles(found) + listOfNotNull(
        incidentRows(shown, listed.incidents),
        Rows("findings-list", TITLE, findingRows(shown, listed.findings), isLong),
        more(shown, listed),
        within(shown, searched),
        skipped(shown, found),
    ) + assigned(shown)
}

private fun heading(shown: FindingsShown, found: RuleResults, searched: SearchedFindings): Heading {
    val counts = if (found.all.isEmpty() && found.ran != null && found.trouble == null) SearchedFindings.NOTHING else searched.counts
    val status = listOf(counts, if (shown.isRunning) RUNNING else "").filter { it.isNotEmpty() }.joinToString()
    if (shown.room != PanelRoom.WHOLE) return Heading(TITLE, status)
    val hasPlaces = found.timeline.places.isNotEmpty()
    return Heading(
        TITLE,
        status,
        listOf(
            Button(
                "Previous finding",
                Action.Press(KeyAction.PREVIOUS_FINDING),
                PartIcon.PREVIOUS,
                "Previous finding (${KeyAction.PREVIOUS_FINDING.shortcut})",
                hasPlaces,
            ),
            Button(
                "Next finding",
                Action.Press(KeyAction.NEXT_FINDING),
                PartIcon.NEXT,
                "Next finding (${KeyAction.NEXT_FINDING.shortcut})",
                hasPlaces,
            ),
            Button("Run the rules again", Action.Ask(FindingRequest.RunRules), PartIcon.AGAIN),
        ),
    )
}

private fun rulesLine(shown: FindingsShown, found: RuleResults): Part? = if (shown.room == PanelRoom.WHOLE) {
    val others = if (shown.isComparing) " Findings of the open log only, not of compared logs." else ""
    Paragraph("rules", "Rules: ${found.rules ?: "built-in"}.$others", Tone.MUTED)
} else {
    null
}

private fun changes(differences: List<Finding>): Part? = if (differences.isEmpty()) {
    null
} else {
    val buttons = differences.map { Button(it.text, Action.Ask(FindingRequest.Compare(it)), hint = Changes.hintOf(it)) }
    Offers("changes", Changes.TITLE, buttons)
}

private fun troubles(found: RuleResults): List<Part> {
    val wrong = found.skipped.filter { it.isMistake }.map { "The rule “${it.rule}” is wrong. ${it.message}" }
    return (listOfNotNull(found.trouble) + wrong).mapIndexed { i, text ->
        Trouble("trouble $i", Severity.WARNING, text.substringBefore('\n'), text.substringAfter('\n', ""))
    }
}

private fun search(shown: FindingsShown, found: RuleResults): Part? {
    if (shown.room != PanelRoom.WHOLE || found.all.isEmpty()) return null
    return Field("search", "Search findings", text = shown.state.query, isSearch = true) { FindingAction.Search(it) }
}

private fun hidden(searched: SearchedFindings): Part? = if (searched.hidden.isEmpty()) {
    null
} else {
    val show = Button("Show them", FindingAction.Search(""), hint = "Show the findings that the search hides")
    Paragraph("findings-hidden", searched.hidden, Tone.MUTED, show)
}

/**
 * The visible part of the list.
 *
 * @property incidents the listed incidents.
 * @property findings the findings that are listed below the incidents.
 * @property left the number of findings and incidents that are not listed.
 */
private class VisibleFindings(val incidents: List<Incident>, val findings: List<Finding>, val left: Int)

private fun listedFindings(shown: FindingsShown, searched: SearchedFindings): VisibleFindings {
    val beside = searched.beside
    if (shown.room == PanelRoom.WHOLE) return VisibleFindings(searched.incidents, beside.outside, left = 0)
    val all = beside.outside + beside.within
    val isNarrow = shown.room == PanelRoom.NARROW
    val wanted = shown.state.listed
    // A phone's first screen should show a graph.
    val few = if (!isNarrow) {
        FEW_FINDINGS
    } else if (searched.incidents.isEmpty()) {
        1
    } else {
        0
    }
    // A button for two more lines is not worth a click.
    val slack = if (few == 0) 0 else SLACK
    val count = wanted ?: if (beside.outside.size <= few + slack) beside.outside.size else few
    val current = shown.visited?.finding
    val incidents = searched.incidents.filterIndexed { i, incident ->
        i == 0 || !isNarrow || wanted != null || (current != null && current in incident)
    }
    // A finding that a person went to is always listed.
    val visited = all.indexOfFirst { it === current }
    val findings = all.take(count) + if (visited >= count) listOf(all[visited]) else emptyList()
    return VisibleFindings(incidents, findings, all.size - findings.size + searched.incidents.size - incidents.size)
}

private fun more(shown: FindingsShown, listed: VisibleFindings): Part? {
    val left = listed.left
    val more = if (left > FINDINGS_AT_A_TIME) "Show more (${countText(left)} left)" else "Show ${countText(left)} more"
    val buttons = listOfNotNull(
        if (left > 0) Button(more, FindingAction.ListMore) else null,
        if (shown.state.listed != null && shown.room != PanelRoom.WHOLE) Button("Show fewer", FindingAction.ListFew) else null,
    )
    return if (buttons.isEmpty()) null else Buttons("findings-more", buttons)
}

private fun within(shown: FindingsShown, searched: SearchedFindings): Part? {
    val within = searched.beside.within
    if (shown.room != PanelRoom.WHOLE || within.isEmpty()) return null
    val isOpen = shown.unfolded["findings-within"] == true || shown.state.query.isNotEmpty() || within.any { it === shown.visited?.finding }
    val title = "${countText(within.size, "more finding")}, part of the incidents"
    return Fold(
        "findings-within",
        title,
        isOpen,
        if (isOpen) listOf(Rows("findings-list", title, findingRows(shown, within))) else emptyList(),
    )
}

private fun skipped(shown: FindingsShown, found: RuleResults): Part? {
    val notLookedAt = found.notLookedAt ?: return null
    val lacking = found.skipped.filter { !it.isMistake }
    if (lacking.isEmpty()) return null
    val isOpen = shown.unfolded["findings-skipped"] == true
    val parts = if (isOpen) lacking(shown, notLookedAt.lacking.take(MAX_LACKING), lacking) else emptyList()
    return Fold("findings-skipped", notLookedAt.text, isOpen, parts)
}

/** Returns fields to assign the missing [signals], lines of code that log them, and the [skipped] rules. */
private fun lacking(shown: FindingsShown, signals: List<String>, skipped: List<SkippedRule>): List<Part> {
    val where = if (shown.room == PanelRoom.WHOLE) " in all logs of this folder" else ""
    val fields = signals.map { signal ->
        Field("signals-lacking $signal", "“$signal” is", "Choose the topic for “$signal”$where", suggestions = shown.topics) {
            Action.Ask(FindingRequest.Assign(signal, it))
        }
    }
    return fields + howToLog(shown.state.library, signals) +
        skipped.map { Paragraph("rule ${it.rule}", "${it.rule}: ${it.message}", Tone.MUTED) }
}

/** Returns the code with which [library] logs the [signals] that a robot program can log. */
private fun howToLog(library: LoggingLibrary, signals: List<String>): List<Part> {
    val lines = signals.mapNotNull { howToLog(it, library) }.distinct()
    val ofStation = signals.filter(::isOfDriverStation).map { signal ->
        Paragraph("station $signal", "“$signal” is in the Driver Station's log: open that beside this one.", Tone.MUTED)
    }
    if (lines.isEmpty()) return ofStation
    val options = LoggingLibrary.entries.map { Button(it.title, FindingAction.ShowLines(it), isOn = it == library) }
    return listOf(
        Choice("logging-library", "How to log what is missing, with", options),
        Paragraph("logging-place", library.place, Tone.MUTED),
        Code("logging-lines", "Lines to write", lines.joinToString("\n")),
    ) + objects(lines) + ofStation
}

/** Returns a note that [lines] call objects of Phoenix 6, if they do. */
private fun objects(lines: List<String>): List<Part> = if (lines.any { "getValueAsDouble" in it }) {
    listOf(Paragraph("logging-objects", "Motors and gyros are those of Phoenix 6; write yours in their place.", Tone.MUTED))
} else {
    emptyList()
}

private fun assigned(shown: FindingsShown): List<Part> {
    if (shown.assigned.isEmpty()) return emptyList()
    val lines = shown.assigned.map { (signal, topic) ->
        val forget = Button("Forget “$signal”", Action.Ask(FindingRequest.Forget(signal)))
        Paragraph("signals-chosen $signal", "“$signal” is “$topic” in this browser.", Tone.MUTED, forget)
    }
    val hint = "For the folder of your logs: there, window and command line use it"
    return lines + Buttons("signals-saved", listOf(Button("Save badlog-signals.toml", Action.Ask(FindingRequest.SaveSignals), hint = hint)))
}

private const val TITLE = "Findings"
private const val RUNNING = "running the rules…"

/** The number of further findings that are also listed, if the list then is complete. */
private const val SLACK = 2

/** The maximum number of signals with a field, as many as a person assigns at a time. */
private const val MAX_LACKING = 5
