package badlog.signals.match.files

import badlog.core.recording.Recording

/** Thrown if files are not of exactly one match; [message] is a sentence. */
class NotOneMatchException(override val message: String) : Exception(message)

/**
 * Returns the logs [files] of one match as one recording, see [recording].
 *
 * @param sentences a sentence about each other file, which cannot be read or is missing.
 * @throws NotOneMatchException if there is no robot's log, or they are of several matches.
 */
fun joinedMatch(files: List<MatchFile>, sentences: List<String>): Recording {
    val found = matchesOf(files)
    if (found.matches.isEmpty()) {
        val none = "There is no robot's log that can be read in it, with which a match begins."
        throw NotOneMatchException((listOf(none) + sentences).joinToString(" "))
    }
    val match = found.matches.singleOrNull() ?: throw NotOneMatchException(
        "It has the logs of ${found.matches.size} matches: ${found.matches.joinToString { it.robot.name }}; put each match into " +
            "a folder or ZIP of its own, or state in a ${MatchManifest.NAME} how their clocks fit.",
    )
    return match.recording(found.left.map { (_, why) -> why } + sentences)
}

/** Returns a sentence about each file that [stated] names, and that is not among those called [names]. */
fun missingOf(stated: List<StatedFile>, names: Set<String>): List<String> =
    stated.filter { it.name !in names }.map { "${it.name} is missing, which ${MatchManifest.NAME} names." }
