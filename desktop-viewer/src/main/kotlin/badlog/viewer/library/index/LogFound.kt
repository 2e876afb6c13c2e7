package badlog.viewer.library.index

import badlog.recording.Severity

/**
 * What the rules found in a log of the folder.
 *
 * @property key of the rules that were run; other rules are run anew.
 * @property rules those that found something, each once, the worst first; null where they could not be run.
 */
internal data class LogFound(val key: Int, val rules: List<FoundRule>?) {
    /** How bad the worst is; null where nothing was found. */
    val worst: Severity? get() = rules?.maxOfOrNull { it.severity }

    /** Returns how many rules found something that is so bad. */
    fun count(severity: Severity): Int = rules.orEmpty().count { it.severity == severity }
}

/** A rule that found something. */
internal data class FoundRule(val name: String, val severity: Severity)
