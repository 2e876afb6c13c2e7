package badlog.signals

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.core.analysis.Units
import badlog.core.analysis.enabledTopics
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind

/** The name of the signal [ACTIVITY]. */
const val ACTIVE = "active"

/** The signal `active`: whether the robot is enabled; always true if the log does not show it. */
val ACTIVITY = Signal(ACTIVE, SignalKind.CONDITION)

/** The name of the signal [SETTLEMENT]. */
const val SETTLED = "settled"

/**
 * The signal `settled`: whether the robot has been enabled for a second in the same mode. Before that, programs set poses and headings, and their
 * first loops are slow. Always true if the log does not show it.
 */
val SETTLEMENT = Signal(SETTLED, SignalKind.CONDITION)

/** Returns the samples of [SETTLEMENT] in [view]. [enabled] has the times when the robot was enabled; null if the log does not show them. */
fun settledIn(view: LogView, enabled: List<EnabledSpan>?): Series {
    val start = view.xAxis.range?.start ?: return Series(DoubleArray(0), DoubleArray(0))
    if (enabled == null) return Series(doubleArrayOf(start), doubleArrayOf(1.0))
    val second = 1 / (Units.secondsIn(view.xAxis.unit) ?: 1.0)
    val changes = arrayListOf(start to 0.0)
    for (stretch in enabled) {
        val from = stretch.span.from + second
        if (from < stretch.span.to) changes += listOf(from to 1.0, stretch.span.to to 0.0)
    }
    return Series(DoubleArray(changes.size) { changes[it].first }, DoubleArray(changes.size) { changes[it].second })
}

/** Returns the samples of [ACTIVITY] in [view]; [enabled] has the times when the robot was enabled. */
fun activeIn(view: LogView, enabled: List<EnabledSpan>): Series {
    val range = view.xAxis.range ?: return Series(DoubleArray(0), DoubleArray(0))
    if (view.enabledTopics().isEmpty()) return Series(doubleArrayOf(range.start), doubleArrayOf(1.0))
    val times = ArrayList<Double>()
    val states = ArrayList<Double>()
    fun set(time: Double, state: Double) {
        if (times.isEmpty() || time > times.last()) {
            times += time
            states += state
        } else {
            states[states.lastIndex] = state
        }
    }
    set(range.start, 0.0)
    for (stretch in enabled) {
        set(stretch.span.from, 1.0)
        if (stretch.span.to < range.endInclusive) set(stretch.span.to, 0.0)
    }
    return Series(times.toDoubleArray(), states.toDoubleArray())
}
