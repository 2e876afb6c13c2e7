package badlog.rules

import badlog.analysis.Units
import badlog.expression.signals.Signal

/**
 * The topics that a rule is asked of one by one. Each list is empty, or the unit null, where the rules do not say. A topic without
 * a unit may have any.
 */
internal class TopicChoice(val patterns: List<NamePattern>, val except: List<NamePattern>, val unit: String?) {
    fun takes(signal: Signal): Boolean = patterns.any { it.matches(signal.name) } && except.none { it.matches(signal.name) } &&
        (unit == null || Units.isNone(signal.unit) || unit.equals(signal.unit, ignoreCase = true))

    override fun toString(): String = patterns.joinToString(" or ") { "“${it.text}”" } + if (unit == null) "" else " in $unit"
}
