package badlog.viewer.todo

import badlog.viewer.text.countText

/** The note on an item that came back: `Again, after it was done before Qualification 58.`; otherwise empty. */
val TodoItem.againText: String
    get() = done?.takeIf { isAgain }?.let { mark ->
        "Again, after it was done ${mark.before?.let(::momentText) ?: "by ${mark.by}"}."
    }.orEmpty()

/** The mark in words: `Done before Qualification 58 by Ada: replaced main breaker`. */
val DoneMark.text: String
    get() = "Done${before?.let { " ${momentText(it)}" }.orEmpty()} by $by${if (what.isEmpty()) "" else ": $what"}"

/** Returns `before Qualification 58`, or `after Qualification 57` if the next match was not named. */
private fun momentText(before: String) = if (before.startsWith(AFTER)) "after ${before.removePrefix(AFTER)}" else "before $before"

/** The details of the item besides its title, one per line: that it came back, the work done, the finding, and the origin. */
val TodoItem.lines: List<String>
    get() = listOfNotNull(
        againText.ifEmpty { null },
        done?.takeIf { !isOpen || isAgain }?.text,
        found?.fault?.text,
        placeText.ifEmpty { null },
    )

/**
 * The origin of the item: `Found in Qualification 60, and 2 logs before.` or `A note in q58.bag.`. Empty for a task in the team's own
 * words.
 */
val TodoItem.placeText: String
    get() = when (val task = task) {
        is NoteTask -> "A note in ${task.log}."

        is OwnTask -> ""

        is FaultTask -> found?.let { last ->
            val before = last.runs - 1
            "Found in ${last.log.title}" + if (before > 0) ", and ${countText(before, "log")} before." else "."
        } ?: "The logs of this folder do not show it."
    }

/** The title of the checklist before [match]. */
fun checklistTitle(match: String): String = "Checklist before $match"
