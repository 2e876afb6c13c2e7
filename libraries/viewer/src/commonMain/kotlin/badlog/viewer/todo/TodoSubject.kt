package badlog.viewer.todo

/** What a line of a to-do file is about. Two laptops that write of the same thing mean the same item, since its content identifies it. */
sealed interface TodoSubject

/** What somebody has to do; an item of the list. */
sealed interface TodoTask : TodoSubject

/**
 * What a rule finds, in whatever log.
 *
 * @property rule the name of the rule.
 * @property topic the one of many topics that the rule is about; null for a rule that is about none, or about the whole robot.
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

/** Anything else to do, in the words of the team. */
data class OwnTask(val text: String) : TodoTask

/**
 * A line of the checklist before a match.
 *
 * @property text the line.
 * @property match the match as people call it, such as `Qualification 58`.
 */
data class Check(val text: String, val match: String) : TodoSubject

/** Which match the team plays next, such as `Qualification 61`: logs do not know the schedule. */
data class NextMatch(val match: String) : TodoSubject
