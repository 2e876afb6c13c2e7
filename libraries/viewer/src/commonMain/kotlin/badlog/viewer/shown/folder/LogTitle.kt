package badlog.viewer.shown.folder

import badlog.signals.match.MatchOfLog
import badlog.signals.match.MatchType

/** Returns the title of [match] in a list: `Q42 · Mill Creek` for qualification 42 of the Mill Creek Regional; null if nothing is known. */
fun shortTitle(match: MatchOfLog): String? {
    val type = match.type?.let(MatchType::of)
    val number = when (type) {
        null, MatchType.PLAYOFF -> match.match

        // The F of finals keeps quarterfinals apart from qualifications.
        else -> match.number?.let { type.title.take(1) + (if (type.title.endsWith("final")) "F" else "") + it }
    }
    return listOfNotNull(number, match.event?.removeSuffix(" Regional")).joinToString(" · ").ifEmpty { null }
}

/**
 * Returns [name], of a file with its folders, in at most [MAX_LETTERS] letters. A longer name loses words in its middle, never a part of a
 * word: its end has the match, its beginning the robot or the day.
 */
fun shortFileName(name: String): String {
    if (name.length <= MAX_LETTERS) return name
    var tail = name.length - MAX_LETTERS * 2 / 3
    while (!beginsWord(name, tail)) if (++tail == name.length) return name
    var head = MAX_LETTERS - 1 - (name.length - tail)
    while (!beginsWord(name, head)) head--
    return "${name.take(head)}…${name.drop(tail)}"
}

/** Returns whether a word of the file name [name] begins at [index]. */
fun beginsWord(name: CharSequence, index: Int): Boolean = index == 0 || name[index - 1] in "/\\_-. "

private const val MAX_LETTERS = 36
