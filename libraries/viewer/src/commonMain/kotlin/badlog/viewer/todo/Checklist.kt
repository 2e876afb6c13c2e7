package badlog.viewer.todo

/** The name of a team's own checklist, beside its logs. */
const val CHECKLIST_FILE: String = "checklist.md"

/**
 * Returns the lines of the checklist in [text], each once and at most [MAX_LINES], cut off after [TodoChange.MAX_TEXT] characters. List
 * markers, such as `- [ ]`, are removed; headings and empty lines are skipped.
 */
fun checklistOf(text: String): List<String> = text.lineSequence()
    .map { it.trim() }
    .filter { !it.startsWith("#") }
    .map { it.replace(LIST_SIGN, "").trim() }
    .filter { it.isNotEmpty() }
    .map { it.take(TodoChange.MAX_TEXT) }
    .distinct()
    .take(MAX_LINES)
    .toList()

/** More lines than a pit goes through between two matches. */
private const val MAX_LINES = 100

private val LIST_SIGN = Regex("^(?:[-*+]|[0-9]{1,3}[.)])?(?:\\s*\\[[ xX]?\\])?(?=\\s|$)")
