package badlog.viewer.panel

import badlog.core.recording.Problem
import badlog.core.recording.Severity
import badlog.viewer.text.countText
import badlog.viewer.text.placeTextOf
import badlog.viewer.text.problemSummary
import badlog.viewer.text.word

/** Returns the [problems] in a log for a panel of their own, the worst first. */
fun problemsPanel(problems: List<Problem>): List<Part> =
    listOf(Heading(TITLE, problemSummary(problems)), list(worstFirst(problems, emptyList())))

/**
 * Returns the [problems] in a log for a place above graphs: a summary that unfolds to their list, or nothing if there are none.
 *
 * @param others warnings about anything but the log, which also open the list; on a phone only if the list is short.
 * @param unfolded the parts that a person has unfolded, see [ViewerState][badlog.viewer.state.ViewerState].
 */
fun problemsAbove(problems: List<Problem>, others: List<Trouble>, unfolded: Map<String, Boolean>, room: PanelRoom): List<Part> {
    val all = worstFirst(problems, others)
    val worst = all.firstOrNull()?.severity ?: return emptyList()
    val hints = all.filter { it.severity == Severity.NOTE }
    val serious = all.dropLast(hints.size)
    val hasFewErrors = worst == Severity.ERROR && all.getOrNull(MAX_LISTED)?.severity != Severity.ERROR
    val needAttention = others.isNotEmpty() || hasFewErrors
    val chosen = unfolded[FOLD]
    val isOpen = when (room) {
        PanelRoom.PAPER -> needAttention || chosen == true

        // A longer list would push all graphs off the first screen.
        PanelRoom.NARROW -> chosen ?: (others.isNotEmpty() && serious.size <= MAX_LISTED_ON_PHONE)

        else -> chosen ?: needAttention
    }
    val parts = when {
        !isOpen -> emptyList()
        serious.isEmpty() -> listOf(list(hints))
        hints.isEmpty() -> listOf(list(serious))
        else -> listOf(list(serious), foldOf(hints, unfolded[HINTS] == true))
    }
    return listOf(Fold(FOLD, problemSummary(problems, others.size), isOpen, parts, worst))
}

private fun worstFirst(problems: List<Problem>, others: List<Trouble>): List<Trouble> =
    (others + problems.mapIndexed(::trouble)).sortedByDescending { it.severity }

private fun trouble(index: Int, problem: Problem) =
    Trouble("problem $index", problem.severity, problem.message, place = placeTextOf(problem), word = problem.word)

private fun foldOf(hints: List<Trouble>, isOpen: Boolean) =
    Fold(HINTS, countText(hints.size, "hint"), isOpen, if (isOpen) listOf(list(hints)) else emptyList())

private fun list(rows: List<Part>) = Rows(LIST, TITLE, rows, isLong = true)

private const val TITLE = "Problems"
private const val LIST = "problem-list"
private const val FOLD = "problems"
private const val HINTS = "hints"
private const val MAX_LISTED = 5
private const val MAX_LISTED_ON_PHONE = 2
