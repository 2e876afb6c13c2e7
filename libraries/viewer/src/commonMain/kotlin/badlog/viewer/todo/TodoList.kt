package badlog.viewer.todo

import badlog.core.recording.Severity
import badlog.signals.match.MatchOfLog
import badlog.signals.match.NaturalOrder

/**
 * What a team has to do: the union of all lines that its laptops wrote, and what the rules found since. Immutable.
 *
 * @property open what is still to be done: what came back first, then the most serious.
 * @property done what was done, the latest first.
 * @property next the match that the team plays next, such as `Qualification 61`, or `the match after Qualification 58` if nobody has said.
 * @property lastMatch the match that was played last, as far as logs know; null for none.
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

    /** Returns what a menu offers for [task] if it is not on the list: an open item. */
    fun itemOrNew(task: TodoTask): TodoItem = items[task] ?: TodoItem(task, isOpen = true, found = (task as? FaultTask)?.let(found::get))

    companion object {
        /** As many matches as are in sight in a pit: their errors are on the list without anybody putting them there. */
        const val RECENT_RUNS: Int = 4

        /**
         * Returns the list that [changes] and [logs] make: the same in whatever order they are, and however often.
         *
         * @param logs the logs of the folder in which there is something to see.
         */
        fun of(changes: Collection<TodoChange>, logs: Collection<FoundLog>): TodoList {
            // What is written twice with one id is damaged; the rest of the line decides, as the same on each laptop.
            val ordered = changes.map { it to it.toLine() }
                .sortedWith(compareBy({ it.first.time }, { it.first.id }, { it.second }))
                .map { it.first }
                .distinctBy { it.id }
            val recorded = logs.distinct().sortedWith(compareByDescending<FoundLog> { it.second }.thenBy { it.name }.thenBy { "$it" })
            val found = lastFound(recorded)
            val ofEach = found.keys.filter { it.topic != null }.mapTo(HashSet()) { it.rule }
            val whole = (found.keys + ordered.map { it.subject })
                .filterTo(HashSet()) { it is FaultTask && it.topic == null && it.rule !in ofEach }
            val ofSubjects = ordered.groupBy { nowNamed(it.subject, whole) }
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

        /** What came back first, then errors, what people wrote, and the rest of what rules find; of one kind the latest first. */
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

        /** The list of those who have not written anything, and have no logs. */
        val EMPTY: TodoList = of(emptyList(), emptyList())
    }
}

/**
 * A line of the checklist before the next match.
 *
 * @property check what it is about.
 * @property done who ticked it off; null if nobody did.
 */
data class CheckedLine(val check: Check, val done: DoneMark?)

/** Returns where each fault of [logs], the latest first, was found last. */
private fun lastFound(logs: List<FoundLog>): Map<FaultTask, LastFound> {
    val runs = HashMap<FaultTask, HashSet<String>>()
    val last = HashMap<FaultTask, Pair<FoundLog, FoundFault>>()
    for (log in logs) {
        for (fault in log.faults) {
            runs.getOrPut(fault.task, ::HashSet) += log.title
            last.getOrPut(fault.task) { log to fault }
        }
    }
    return last.mapValues { (task, where) -> LastFound(where.first, where.second, runs.getValue(task).size) }
}

/** Returns the item of [task], which [changes] are about; null if it is not on the list. */
private fun itemOf(task: TodoTask, changes: List<TodoChange>, found: Map<FaultTask, LastFound>, logs: List<FoundLog>): TodoItem? {
    val fault = (task as? FaultTask)?.let(found::get)
    val last = changes.lastOrNull { it.deed !is TodoDeed.Assign }
    val person = changes.mapNotNull { (it.deed as? TodoDeed.Assign)?.person }.lastOrNull().orEmpty()
    val done = changes.mapNotNull { it.mark() }.lastOrNull()
    return when (last?.deed) {
        // Whoever takes on what is not on the list puts it there.
        TodoDeed.Remove -> if (changes.last().deed is TodoDeed.Assign) TodoItem(task, true, person, done, found = fault) else null

        is TodoDeed.Done -> {
            val isAgain = fault != null && logs.any { log -> log.faults.any { it.task == task } && done?.isBefore(log) == true }
            TodoItem(task, isAgain, person, done, isAgain, fault)
        }

        else -> TodoItem(task, true, person, done, found = fault)
    }
}

/** Returns [subject] as rules name it now: older lines have a topic for rules that are about the [whole] robot, too. */
private fun nowNamed(subject: TodoSubject, whole: Set<TodoSubject>): TodoSubject =
    (subject as? FaultTask)?.copy(topic = null)?.takeIf { it in whole } ?: subject

internal fun TodoChange.mark(): DoneMark? = (deed as? TodoDeed.Done)?.let { DoneMark(this, it) }

/** Returns the match that the team plays next, as of its last word in [changes], unless it is among [logs]; otherwise the one after [last]. */
private fun nextOf(changes: List<TodoChange>, logs: List<FoundLog>, last: MatchOfLog?): String {
    val said = changes.lastOrNull { it.subject is NextMatch && it.deed != TodoDeed.Remove }
    val match = (said?.subject as? NextMatch)?.match
    fun isPlayed(log: FoundLog) = log.match.match != null && (log.isDated || log.match.event == said?.event)
    if (match != null && logs.none { isPlayed(it) && said.isBefore(it, match) }) return match
    return last?.match?.let { AFTER + it } ?: SOME_MATCH
}
