package badlog.viewer.state

import badlog.rules.Finding
import badlog.viewer.draw.mark.FindingPlace

/** Returns the outcome of [action] from this state, for a log with the content [shown]. */
internal fun ViewerState.after(shown: Shown, action: FindingAction): Outcome = when (action) {
    is FindingAction.GoTo -> visiting(action.place, FindingRequest.Show(action.place, action.incident, action.isWhole))
    is FindingAction.StepWithin -> steppedWithin(shown, action.steps)
    is FindingAction.Select -> Outcome(at(place.copy(wanted = action.finding)).selected(shown))
    FindingAction.Know -> Outcome(selected(shown))
    is FindingAction.Search -> findings { copy(query = action.text, listed = null) }
    FindingAction.ListMore -> findings { copy(listed = (listed ?: 0) + FINDINGS_AT_A_TIME) }
    FindingAction.ListFew -> findings { copy(listed = null) }
    FindingAction.Forget -> Outcome(copy(findings = FindingsState(library = findings.library), unfolded = emptyMap()))
    is FindingAction.ShowLines -> findings { copy(library = action.library) }
    is FindingAction.Refuse -> findings { copy(refusal = action.reason) }
}

/** Goes to the step [steps] after the visited finding, in the order of keys. */
internal fun ViewerState.nextFinding(shown: Shown, steps: Int): Outcome {
    val step = shown.found?.order?.beside(place.visited?.finding, place.cursors.x ?: Double.NaN, steps)
    if (step == null) return Outcome(this, FindingRequest.AnnounceNone)
    return visiting(step.place, FindingRequest.Show(step.place, step.incident, step.incident != null, step.spoken))
}

private fun ViewerState.findings(step: FindingsState.() -> FindingsState) = Outcome(copy(findings = findings.step()))

private fun ViewerState.selected(shown: Shown): ViewerState {
    val (rule, topic, x) = place.wanted ?: return this
    fun isSelected(finding: Finding) = finding.rule == rule && finding.topic == topic
    val found = shown.found?.timeline?.placeAt(x, ::isSelected)?.takeIf { isSelected(it.finding) } ?: return this
    return at(place.copy(visited = found, wanted = null))
}

private fun ViewerState.steppedWithin(shown: Shown, steps: Int): Outcome {
    val visited = place.visited ?: return Outcome(this)
    val next = shown.found?.timeline?.within(visited.finding, visited.span.from, steps) ?: return Outcome(this)
    return visiting(next, FindingRequest.Show(next, shown.found?.incidentOf(next.finding), isWhole = false))
}

private fun ViewerState.visiting(goal: FindingPlace<Finding>, request: Request) = Outcome(at(place.visiting(goal)), request)

/** The number of findings beside incidents that are listed until a person asks for more. */
internal const val FEW_FINDINGS = 5

/** The number of findings that are added to the list at a time. */
internal const val FINDINGS_AT_A_TIME = 300
