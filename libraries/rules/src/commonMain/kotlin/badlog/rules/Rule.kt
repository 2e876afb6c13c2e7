package badlog.rules

import badlog.recording.Severity

/**
 * What is to be looked for in every log; `docs/rules.md` says what each part means.
 *
 * @property name what it is called; no two rules of a set have the same.
 * @property severity how bad it is.
 * @property condition the expression under `when`, its limits filled in.
 * @property only the types of match that it is for; empty for all.
 * @property group what it is about, such as `power`; empty for none, and in rules that were read from JSON.
 * @property reason why it is looked for, as a sentence; empty where nobody says, and in rules that were read from JSON.
 * @property next what to look at next where it holds, as a sentence; empty where nobody says.
 */
public class Rule internal constructor(
    public val name: String,
    public val severity: Severity,
    public val condition: String,
    internal val text: RuleText,
    public val only: List<String>,
    internal val each: TopicChoice?,
    internal val place: RulePlace?,
    public val group: String = "",
    public val reason: String = "",
    public val next: String = "",
    internal val show: List<String> = emptyList(),
    internal val unless: List<String> = emptyList(),
    internal val isForEachText: Boolean = false,
    internal val isForWholeLogs: Boolean = false,
) {
    /** Whether it is badlog's own, in which nobody need look for a mistake. */
    public val isBuiltIn: Boolean get() = place == null

    /** Whether it is to be asked of a match of the type [type]. */
    internal fun isFor(type: String?): Boolean = only.isEmpty() || (type != null && only.any { it.equals(type, ignoreCase = true) })
}
