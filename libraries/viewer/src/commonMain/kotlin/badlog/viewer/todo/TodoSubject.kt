package badlog.viewer.todo

/**
 * The subject of a line in a to-do file. Its content identifies it, so two laptops that write about the same thing mean the same item.
 */
sealed interface TodoSubject

/** A task; an item of the list. */
sealed interface TodoTask : TodoSubject

/**
 * A fault that a rule finds, in any log.
 *
 * @property rule the name of the rule.
 * @property topic the topic of this fault, for a rule that is about each of many topics; null for any other rule.
 */
data class FaultTask(val rule: String, val topic: String?) : TodoTask

/**
 * A note about a moment of a log.
 *
 * @property log the name of the log's file.
 * @property x the moment, in the unit of the log's x axis; finite.
 * @property text the text of the note when it was put on the list.
 */
data class NoteTask(val log: String, val x: Double, val text: String) : TodoTask

/** Any other task, in the words of the team. */
data class OwnTask(val text: String) : TodoTask

/**
 * A line of the checklist before a match.
 *
 * @property text the line.
 * @property match the match as people call it, such as `Qualification 58`.
 */
data class Check(val text: String, val match: String) : TodoSubject

/** The match that the team plays next, such as `Qualification 61`: logs do not know the schedule. */
data class NextMatch(val match: String) : TodoSubject
