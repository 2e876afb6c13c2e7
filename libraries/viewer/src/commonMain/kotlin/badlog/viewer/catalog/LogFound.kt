package badlog.viewer.catalog

import badlog.core.recording.Severity

/**
 * What the rules found in a log of the folder.
 *
 * @property key identifies the rules that were run; with other rules, they are run again.
 * @property rules those that found something, each once, the worst first; null if they could not be run.
 */
data class LogFound(val key: Int, val rules: List<FoundRule>?) {
    /** The worst severity; null if nothing was found. */
    val worst: Severity? get() = rules?.maxOfOrNull { it.severity }

    /** Returns how many rules found something of [severity]. */
    fun count(severity: Severity): Int = rules.orEmpty().count { it.severity == severity }
}

/** A rule that found something. */
data class FoundRule(val name: String, val severity: Severity)
