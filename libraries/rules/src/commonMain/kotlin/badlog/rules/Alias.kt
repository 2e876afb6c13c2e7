package badlog.rules

import badlog.analysis.Units
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind

/**
 * A name that rules use for a topic which is called differently from log to log.
 *
 * @property names the patterns, the first that fits a topic counts.
 * @property unit the unit in which rules get the numbers, or null for the topic's own.
 */
internal class Alias(val name: String, val names: List<NamePattern>, val unit: String?) {
    /** Which of [signals] it means, or null. */
    fun find(signals: List<Signal>): NamedSignal? = names.firstNotNullOfOrNull { pattern ->
        signals.firstNotNullOfOrNull { if (pattern.matches(it.name)) named(it) else null }
    }

    private fun named(signal: Signal): NamedSignal? {
        val wanted = unit ?: return NamedSignal(name, signal, 1.0, signal.unit)
        if (signal.kind != SignalKind.NUMBER) return null
        val scale = scale(signal.unit, wanted) ?: return null
        return NamedSignal(name, signal, scale, wanted)
    }
}

/** What a number in [from] is to be multiplied with to be one in [to]; null when they do not measure the same. */
private fun scale(from: String, to: String): Double? {
    if (Units.isNone(from) || from.equals(to, ignoreCase = true)) return 1.0
    val seconds = Units.secondsIn(from)
    if (seconds != null) return Units.secondsIn(to)?.let { seconds / it }
    val group = UNITS.find { from.lowercase() in it && to.lowercase() in it } ?: return null
    return group.getValue(from.lowercase()) / group.getValue(to.lowercase())
}

private val UNITS = listOf(
    mapOf("kv" to 1e3, "v" to 1.0, "volt" to 1.0, "volts" to 1.0, "mv" to 1e-3),
    mapOf("a" to 1.0, "amp" to 1.0, "amps" to 1.0, "ma" to 1e-3),
    mapOf("%" to 1.0, "percent" to 1.0),
)
