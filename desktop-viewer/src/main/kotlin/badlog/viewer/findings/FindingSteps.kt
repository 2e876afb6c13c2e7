package badlog.viewer.findings

import androidx.compose.ui.input.key.Key
import badlog.report.rules.Finding
import badlog.viewer.app.Command
import badlog.viewer.app.KeyPress
import badlog.viewer.app.Viewer

/** Takes the cursor and the view to [finding], and shades its time; one of the whole log is only chosen. */
internal fun goTo(viewer: Viewer, finding: Finding) {
    viewer.findings = viewer.findings.copy(chosen = finding)
    if (!finding.time.isFinite()) return
    viewer.cursor = finding.time
    viewer.isCursorPinned = true
    viewer.viewport = viewer.viewport.revealing(finding.time)
}

/** Goes to the finding that is [steps] further on than the one of before, or else than the cursor. */
internal fun stepFinding(viewer: Viewer, steps: Int) {
    // Who has moved the cursor meanwhile goes on from there.
    val from = viewer.findings.chosen?.takeIf { it.time == viewer.cursor }
    viewer.findings.list?.stepped(steps, from, viewer.cursor)?.let { goTo(viewer, it) }
}

/** What the keyboard does with findings. */
internal fun findingCommands(viewer: Viewer): List<Command> = listOf(
    Command(GROUP, "To the next finding", listOf(NEXT)) { stepFinding(viewer, 1) },
    Command(GROUP, "To the finding before", listOf(BEFORE)) { stepFinding(viewer, -1) },
)

internal val NEXT = KeyPress(Key.N, "N")
internal val BEFORE = KeyPress(Key.N, "N", shift = true)
private const val GROUP = "Findings"
