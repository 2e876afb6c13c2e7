package badlog.viewer.panel

import badlog.core.recording.Problem
import badlog.core.recording.Severity
import badlog.viewer.text.countText
import badlog.viewer.text.placeTextOf
import badlog.viewer.text.problemSummary
import badlog.viewer.text.word

/**
 * Returns the [problems] in a log, the worst first; without room, a summary that unfolds to their list, or nothing if there are none.
 *
 * @param others warnings about anything but the log, which also open the list; on a phone only if the list is short.
 * @param unfolded what a person has unfolded, see [ViewerState][badlog.viewer.state.ViewerState].
 */
fun problemsPanel(
    problems: List<Problem>,
    others: List<Trouble> = emptyList(),
    unfolded: Map<String, Boolean> = emptyMap(),
    room: PanelRoom = PanelRoom.WHOLE,
): List<Part> {
    val summary = problemSummary(problems, others.size)
    val all = (others + problems.mapIndexed(::trouble)).sortedByDescending { it.severity }
    if (room == PanelRoom.WHOLE) return listOf(Heading(TITLE, summary), list(all))
    val worst = all.firstOrNull()?.severity ?: return emptyList()
    val (hints, serious) = all.partition { it.severity == Severity.NOTE }
    val isOpen = isListed(serious, others, unfolded[FOLD], room)
    val parts = when {
        !isOpen -> emptyList()
        serious.isEmpty() -> listOf(list(hints))
        else -> listOfNotNull(list(serious), if (hints.isEmpty()) null else foldOf(hints, unfolded[HINTS] == true))
    }
    return listOf(Fold(FOLD, summary, isOpen, parts, severity = worst))
}

private fun trouble(index: Int, problem: Problem) =
    Trouble("problem $index", problem.severity, problem.message, place = placeTextOf(problem), word = problem.word)

/** Returns whether the [serious] problems are listed: as a person has [chosen], otherwise if a few need attention. */
private fun isListed(serious: List<Trouble>, others: List<Trouble>, chosen: Boolean?, room: PanelRoom): Boolean {
    val isWorthIt = others.isNotEmpty() || serious.count { it.severity == Severity.ERROR } in 1..MAX_LISTED
    return when (room) {
        PanelRoom.PAPER -> isWorthIt || chosen == true
        // A longer list would push all graphs off the first screen.
        PanelRoom.NARROW -> chosen ?: (others.isNotEmpty() && serious.size <= MAX_LISTED_ON_PHONE)
        else -> chosen ?: isWorthIt
    }
}

private fun foldOf(hints: List<Trouble>, isOpen: Boolean) =
    Fold(HINTS, countText(hints.size, "hint"), isOpen, if (isOpen) listOf(list(hints)) else emptyList())

private fun list(rows: List<Part>) = Rows(LIST, TITLE, rows, isLong = true)

private const val TITLE = "Problems"
private const val LIST = "problem-list"
private const val FOLD = "problems"
private const val HINTS = "hints"
private const val MAX_LISTED = 5
private const val MAX_LISTED_ON_PHONE = 2
