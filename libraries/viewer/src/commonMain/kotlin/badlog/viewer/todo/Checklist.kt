package badlog.viewer.todo

/** The name of a team's own checklist, beside its logs. */
const val CHECKLIST_FILE: String = "checklist.md"

/**
 * Returns the lines of the checklist in [text], each once and at most [MAX_LINES]: every line of it, without the signs that make it a list, such
 * as `- [ ]`. Headings and empty lines are not part of it.
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

/** More than a pit goes through between two matches. */
private const val MAX_LINES = 100

private val LIST_SIGN = Regex("^(?:[-*+]|[0-9]{1,3}[.)])?(?:\\s*\\[[ xX]?\\])?(?=\\s|$)")
