package badlog.rules

import badlog.core.recording.Severity
import badlog.rules.standing.PROVEN_TRUST
import badlog.rules.standing.Standing
import badlog.rules.standing.trustOf

/**
 * A condition to look for in every log; `docs/rules.md` explains each part.
 *
 * @property name its name, unique in a set of rules.
 * @property severity how serious it is.
 * @property condition the expression under `when`, with its limits filled in.
 * @property only the types of match to which it applies; empty for all.
 * @property group its subject, such as `power`; empty for none, and in rules that were read from JSON.
 * @property reason why the rule exists, as a sentence; empty if not given, and in rules that were read from JSON.
 * @property next the next step if it holds, as a sentence; empty if not given.
 * @property checklist the item to check before each match to prevent it; empty if not given, and in rules of a page.
 * @param isAboutProgram whether it is about the program's messages or the drivers' inputs, which a simulated robot also has.
 * @property trust how far its findings can be relied on, from 0 to [PROVEN_TRUST]; see [trustOf].
 * @property isOncePerEvent whether elements of a list with findings that begin within a second, or topics with the same spans, are one.
 */
class Rule internal constructor(
    val name: String,
    val severity: Severity,
    val condition: String,
    internal val text: RuleText,
    val only: List<String>,
    internal val each: TopicChoice?,
    internal val place: RulePlace?,
    val group: String = "",
    val reason: String = "",
    val next: String = "",
    internal val show: List<String> = emptyList(),
    internal val unless: List<String> = emptyList(),
    internal val isForEachText: Boolean = false,
    internal val needs: List<LogEdge> = emptyList(),
    val checklist: String = "",
    private val isAboutProgram: Boolean = false,
    internal val isOncePerEvent: Boolean = false,
    val trust: Double = PROVEN_TRUST,
) {
    /** The standing of the rule; a rule that a team wrote is proven. */
    val standing: Standing get() = Standing.of(trust)

    /** Whether it is a built-in rule: users need not look for a mistake in it. */
    val isBuiltIn: Boolean get() = place == null

    /** Whether it also runs over the log of a simulated robot: built-in rules about power, wear and sensors do not. */
    val isForSimulations: Boolean get() = isAboutProgram || !isBuiltIn

    /** Returns whether it applies to a match of the type [type]. */
    internal fun isFor(type: String?): Boolean = only.isEmpty() || (type != null && only.any { it.equals(type, ignoreCase = true) })
}
