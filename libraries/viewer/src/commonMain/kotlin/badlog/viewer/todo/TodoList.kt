package badlog.viewer.todo

import badlog.core.recording.Severity
import badlog.signals.match.MatchOfLog
import badlog.signals.match.NaturalOrder

/**
 * A team's list of things to do. It combines the lines from all laptops with the recent findings of the rules. Immutable.
 *
 * @property open the open items: the ones that came back first, then the most serious.
 * @property done the items that were done, the latest first.
 * @property next the match that the team plays next, such as `Qualification 61`; if unknown, `the match after Qualification 58`.
 * @property lastMatch the last played match in the logs; null if there is none.
 */
class TodoList private constructor(
    val open: List<TodoItem>,
    val done: List<TodoItem>,
    val next: String,
    val lastMatch: MatchOfLog?,
    private val items: Map<TodoTask, TodoItem>,
    private val ticks: Map<String, DoneMark>,
    private val found: Map<FaultTask, LastFound>,
) {
    /** Returns the item of [task]; null if it is not on the list. */
    fun item(task: TodoTask): TodoItem? = items[task]

    /** Returns [lines] as the checklist before the [next] match. */
    fun checklist(lines: List<String>): List<CheckedLine> = lines.map { CheckedLine(Check(it, next), ticks[it]) }

    /** Returns the item of [task], or a new open item for a menu if the list does not have it. */
    fun itemOrNew(task: TodoTask): TodoItem = items[task] ?: TodoItem(task, isOpen = true, found = (task as? FaultTask)?.let(found::get))

    companion object {
        /** The number of last matches that matter in a pit: their errors are put on the list automatically. */
        const val RECENT_RUNS: Int = 4

        /**
         * Returns the list of [changes] and [logs]. Neither their order nor repetitions matter.
         *
         * @param logs the logs of the folder that have something to see.
         */
        fun of(changes: Collection<TodoChange>, logs: Collection<TodoLog>): TodoList {
            // Two lines with one id are damaged; the text of the line decides, so that all laptops agree.
            val ordered = changes.map { it to it.toLine() }
                .sortedWith(compareBy({ it.first.time }, { it.first.id }, { it.second }))
                .map { it.first }
                .distinctBy { it.id }
            val recorded = logs.distinct().sortedWith(compareByDescending<TodoLog> { it.second }.thenBy { it.name }.thenBy { "$it" })
            val found = lastFound(recorded)
            val ofEach = found.keys.filter { it.topic != null }.mapTo(HashSet()) { it.rule }
            val whole = (found.keys + ordered.map { it.subject })
                .filterTo(HashSet()) { it is FaultTask && it.topic == null && it.rule !in ofEach }
            val ofSubjects = ordered.groupBy { withCurrentName(it.subject, whole) }
            val recent = recentOf(recorded).toSet()
            val tasks = ofSubjects.keys.filterIsInstance<TodoTask>().toSet() +
                found.filterValues { it.severity == Severity.ERROR && it.log in recent }.keys
            val items = tasks.mapNotNull { task -> itemOf(task, ofSubjects[task].orEmpty(), found, recorded) }
            val last = lastMatchOf(recorded)?.match
            val next = nextOf(ordered, recorded, last)
            val (open, done) = items.partition { it.isOpen }
            return TodoList(
                open.sortedWith(OPEN),
                done.sortedWith(compareByDescending { it.done?.order.orEmpty() }),
                next,
                last,
                items.associateBy { it.task },
                ticksOf(ordered, recorded, next),
                found,
            )
        }

        /** Items that came back are first, then errors, items of people, and the other findings. Within each kind, the latest is first. */
        private val OPEN: Comparator<TodoItem> = compareBy<TodoItem> { if (it.isAgain) 0 else 1 }
            .thenBy { rankOf(it) }
            .thenByDescending { it.found?.log?.second ?: Long.MIN_VALUE }
            .thenBy(NaturalOrder) { it.title }
            .thenBy { "${it.task}" }

        private fun rankOf(item: TodoItem): Int = when (item.found?.severity) {
            Severity.ERROR -> 0
            null -> 1
            Severity.WARNING -> 2
            Severity.NOTE -> 3
        }

        /** The list without changes and logs. */
        val EMPTY: TodoList = of(emptyList(), emptyList())
    }
}

/**
 * A line of the checklist before the next match.
 *
 * @property check the line and its match.
 * @property done the person and time of the tick; null if there is none.
 */
data class CheckedLine(val check: Check, val done: DoneMark?)

/** Returns the last place of each fault in [logs]; the latest log must be first. */
private fun lastFound(logs: List<TodoLog>): Map<FaultTask, LastFound> {
    val runs = HashMap<FaultTask, HashSet<String>>()
    val last = HashMap<FaultTask, Pair<TodoLog, FoundFault>>()
    for (log in logs) {
        for (fault in log.faults) {
            runs.getOrPut(fault.task, ::HashSet) += log.title
            last.getOrPut(fault.task) { log to fault }
        }
    }
    return last.mapValues { (task, where) -> LastFound(where.first, where.second, runs.getValue(task).size) }
}

/** Returns the item of [task] with [changes] applied; null if it is not on the list. */
private fun itemOf(task: TodoTask, changes: List<TodoChange>, found: Map<FaultTask, LastFound>, logs: List<TodoLog>): TodoItem? {
    val fault = (task as? FaultTask)?.let(found::get)
    val last = changes.lastOrNull { it.deed !is TodoDeed.Assign }
    val person = changes.mapNotNull { (it.deed as? TodoDeed.Assign)?.person }.lastOrNull().orEmpty()
    val done = changes.mapNotNull { it.mark() }.lastOrNull()
    return when (last?.deed) {
        // Assigning a removed item puts it on the list again.
        TodoDeed.Remove -> if (changes.last().deed is TodoDeed.Assign) TodoItem(task, true, person, done, found = fault) else null

        is TodoDeed.Done -> {
            val isAgain = fault != null && logs.any { log -> log.faults.any { it.task == task } && done?.isBefore(log) == true }
            TodoItem(task, isAgain, person, done, isAgain, fault)
        }

        else -> TodoItem(task, true, person, done, found = fault)
    }
}

/** Returns [subject] as rules name it now. Older lines also have a topic for rules that are about the [whole] robot. */
private fun withCurrentName(subject: TodoSubject, whole: Set<TodoSubject>): TodoSubject =
    (subject as? FaultTask)?.copy(topic = null)?.takeIf { it in whole } ?: subject

internal fun TodoChange.mark(): DoneMark? = (deed as? TodoDeed.Done)?.let { DoneMark(this, it) }

/**
 * Returns the match that the team plays next: the last one named in [changes], unless [logs] have it. Otherwise returns the match after
 * [last].
 */
private fun nextOf(changes: List<TodoChange>, logs: List<TodoLog>, last: MatchOfLog?): String {
    val said = changes.lastOrNull { it.subject is NextMatch && it.deed != TodoDeed.Remove }
    val match = (said?.subject as? NextMatch)?.match
    fun isPlayed(log: TodoLog) = log.match.match != null && (log.isDated || log.match.event == said?.event)
    if (match != null && logs.none { isPlayed(it) && said.isBefore(it, match) }) return match
    return last?.match?.let { AFTER + it } ?: UNNAMED_MATCH
}

/**
 * Returns the lines of the checklist that were ticked off before the match [next], with the person and the time.
 *
 * A tick is for one match: leaving the pit unchecked because of an earlier tick is worse than checking the robot twice. A tick stays if
 * it was made before the team named the next match.
 *
 * @param changes all changes, in their order.
 * @param logs the logs of the folder.
 */
internal fun ticksOf(changes: List<TodoChange>, logs: Collection<TodoLog>, next: String): Map<String, DoneMark> {
    val newest = logs.filter { it.isDated }.maxByOrNull { it.second }
    val last = lastMatchOf(logs)
    val words = changes.mapNotNull { change -> (change.subject as? NextMatch)?.let { change.time to it.match } }

    fun isOfNext(change: TodoChange, match: String): Boolean {
        if (newest != null && !change.isOfSameEventAs(newest, isPractice = next == UNNAMED_MATCH)) return false
        if (match == next) return true
        if (!match.startsWith(AFTER) && match != UNNAMED_MATCH) return false
        if (last != null && (!last.isDated || change.seen == null || change.seen < last.second)) return false
        val said = words.filter { it.first > change.time }
        return said.isNotEmpty() && said.all { it.second == next }
    }

    val ticks = HashMap<String, DoneMark>()
    for (change in changes) {
        val check = change.subject as? Check ?: continue
        if (change.deed is TodoDeed.Assign || !isOfNext(change, check.match)) continue
        val mark = change.mark()
        if (mark == null) ticks -= check.text else ticks[check.text] = mark
    }
    return ticks
}

/** Returns whether this change was made at the event of [newest], and also after it if [isPractice]. */
private fun TodoChange.isOfSameEventAs(newest: TodoLog, isPractice: Boolean): Boolean {
    if (event != null && newest.match.event != null && event != newest.match.event) return false
    if (seen == null) return true
    return newest.second - seen <= LONGEST_EVENT && !(isPractice && seen < newest.second)
}

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
