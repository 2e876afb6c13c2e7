package badlog.rules

import badlog.analysis.Units
import badlog.expression.signals.Signal
import badlog.rules.signal.NamePattern

/** The topics that a rule is asked of one by one. */
internal sealed interface TopicChoice

/** Those that fit one of [patterns] and none of [except]. A topic without a unit may have any; [unit] is null where rules do not say. */
internal class TopicsByName(val patterns: List<NamePattern>, val except: List<NamePattern>, val unit: String?) : TopicChoice {
    fun takes(signal: Signal): Boolean = patterns.any { it.matches(signal.name) } && except.none { it.matches(signal.name) } &&
        (unit == null || Units.isNone(signal.unit) || unit.equals(signal.unit, ignoreCase = true))

    override fun toString(): String = patterns.joinToString(" or ") { "“${it.text}”" } + if (unit == null) "" else " in $unit"
}

/**
 * Those that are the signal [signal].
 *
 * @property with signals of the same device that the rule also needs.
 * @property isLinked whether the rule is about two of them whose devices are linked; the second is [RuleProgram.OTHER].
 */
internal class TopicsOfSignal(val signal: String, val with: List<String>, val isLinked: Boolean) : TopicChoice
