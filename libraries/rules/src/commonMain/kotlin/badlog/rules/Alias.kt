package badlog.rules

import badlog.core.analysis.Units
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.signals.NamedSignal
import badlog.signals.ScaledSignal
import badlog.signals.vocabulary.NamePattern
import badlog.signals.vocabulary.unitScale

/**
 * A name in a file of rules for a topic that has different names in different logs.
 *
 * @property names the patterns; the first that matches a topic counts.
 * @property unit the unit of the numbers that rules receive; null for the topic's own.
 */
internal class Alias(val name: String, val names: List<NamePattern>, val unit: String?) {
    /** Returns the one of [signals] that the name refers to; null if there is none. */
    fun find(signals: List<Signal>): NamedSignal? = names.firstNotNullOfOrNull { pattern ->
        signals.firstNotNullOfOrNull { if (pattern.matches(it.name)) named(it) else null }
    }

    private fun named(signal: Signal): NamedSignal? {
        val wanted = unit ?: return NamedSignal.of(name, signal)
        if (signal.kind != SignalKind.NUMBER) return null
        val scale = if (!Units.isNone(signal.unit)) unitScale(signal.unit, wanted) ?: return null else 1.0.takeIf { wanted != PERCENT }
        return NamedSignal(name, listOf(ScaledSignal(signal, scale, NamedSignal.wholeIn(wanted))), wanted)
    }
}

private const val PERCENT = "%"
