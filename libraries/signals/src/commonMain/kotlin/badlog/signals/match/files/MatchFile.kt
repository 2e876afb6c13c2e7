package badlog.signals.match.files

import badlog.signals.clock.ClockedLog

/**
 * The program or device that wrote a file of a match.
 *
 * @property role its name for people and in a `match.json`.
 */
enum class FileRole(val role: String) {
    /** A robot's program. */
    ROBOT("robot"),

    /** The Driver Station. */
    STATION("driver station"),

    /** CTRE's devices of a CAN bus: a `.hoot`. */
    CAN_BUS("can bus"),

    /** REV's motor controllers: a `.revlog`. */
    MOTORS("motors"),
    ;

    companion object {
        /** Returns the role called [text], regardless of case; null if there is none. */
        fun of(text: String): FileRole? = entries.find { it.role.equals(text.trim(), ignoreCase = true) }
    }
}

/**
 * A log that may belong to a match.
 *
 * @property name its name, unique among the files.
 * @property log its content.
 * @property seconds the offset of its clock, in s, if it was stated; null if it is to be found.
 * @property error the possible error of [seconds], in s; null if it was not stated.
 */
class MatchFile(val name: String, val role: FileRole, val log: ClockedLog, val seconds: Double? = null, val error: Double? = null)

/** How the clock of a file was found. */
enum class ClockReason {
    /** It is the clock of the match. */
    OWN,

    /** A `match.json` stated it. */
    STATED,

    /** By the moments at which the robot was enabled and disabled. */
    ENABLED,

    /** By the moments at which motors were driven. */
    MOTORS,

    /** By the battery voltage, which moves alike in both. */
    BATTERY,

    /** By the time of day on both clocks, which may be seconds off. */
    SYSTEM_TIME,
}

/**
 * A file on the clock of its match.
 *
 * @property seconds the offset to add to its times, in s.
 * @property error the possible error of [seconds], in s; null if unknown.
 * @property edges the number of moments that match; 0 if there are none to count.
 */
class MatchPart(val file: MatchFile, val seconds: Double, val reason: ClockReason, val error: Double? = null, val edges: Int = 0) {
    /** How its clock was found, as the end of a sentence. */
    val why: String
        get() {
            val within = error?.let { ", within ${millisOf(it)} ms" }.orEmpty()
            return when (reason) {
                ClockReason.OWN -> "the clock of the match"
                ClockReason.STATED -> "as stated$within"
                ClockReason.ENABLED -> "$edges edges of enabled fit$within"
                ClockReason.MOTORS -> "$edges edges of motors driven fit$within"
                ClockReason.BATTERY -> "the battery voltage moves alike$within"
                ClockReason.SYSTEM_TIME -> "by the time of day, which may be seconds off"
            }
        }

    private fun millisOf(seconds: Double) = kotlin.math.ceil(seconds * 1000 - 1e-6).toLong()
}

/**
 * The files of one match.
 *
 * @property parts the files on the clock of the first, which is a robot's log.
 * @property sentences a sentence about each missing file.
 */
class OneMatch(val parts: List<MatchPart>, val sentences: List<String>) {
    /** The robot's log that has the clock of the match. */
    val robot: MatchFile get() = parts.first().file
}

/**
 * The matches found among files that were given together.
 *
 * @property matches the matches, in the order of their robots' logs.
 * @property left the files that are in no match, each with a sentence that says why, and what to do.
 */
class FoundMatches(val matches: List<OneMatch>, val left: List<Pair<MatchFile, String>>)
