package badlog.rules

import badlog.core.analysis.Units
import badlog.expression.signals.Signal
import badlog.signals.vocabulary.NamePattern

/** The topics for which a rule runs, one at a time. */
internal sealed interface TopicChoice

/**
 * Topics that match one of [patterns] and none of [except]. A topic without a unit matches any [unit], which is null if the rule does not
 * specify it.
 */
internal class TopicsByName(val patterns: List<NamePattern>, val except: List<NamePattern>, val unit: String?) : TopicChoice {
    fun takes(signal: Signal): Boolean = patterns.any { it.matches(signal.name) } && except.none { it.matches(signal.name) } &&
        (unit == null || Units.isNone(signal.unit) || unit.equals(signal.unit, ignoreCase = true))

    override fun toString(): String = patterns.joinToString(" or ") { "“${it.text}”" } + if (unit == null) "" else " in $unit"
}

/**
 * The topics of the signal [signal].
 *
 * @property with signals of the same device that the rule also needs.
 * @property isLinked whether the rule is about pairs of topics with linked devices; the second topic is [RuleProgram.OTHER].
 * @property hasIds whether it is also about devices that are named only by ids; their values and the values of [with] come at different
 *   times.
 */
internal class TopicsOfSignal(val signal: String, val with: List<String>, val isLinked: Boolean, val hasIds: Boolean) : TopicChoice
