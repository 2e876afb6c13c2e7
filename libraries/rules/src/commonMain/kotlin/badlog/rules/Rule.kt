package badlog.rules

import badlog.recording.Severity

/**
 * What is to be looked for in every log; `docs/rules.md` says what each part means.
 *
 * @property name what it is called; no two rules of a set have the same.
 * @property severity how bad it is.
 * @property condition the expression under `when`.
 * @property only the types of match that it is for; empty for all.
 */
public class Rule internal constructor(
    public val name: String,
    public val severity: Severity,
    public val condition: String,
    internal val text: RuleText,
    public val only: List<String>,
    internal val each: TopicChoice?,
    internal val place: RulePlace,
) {
    /** Whether it is to be asked of a match of the type [type]. */
    internal fun isFor(type: String?): Boolean = only.isEmpty() || (type != null && only.any { it.equals(type, ignoreCase = true) })
}
