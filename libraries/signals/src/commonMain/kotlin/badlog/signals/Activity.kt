package badlog.signals

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.core.analysis.enabledTopics
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind

/** The name of the signal [ACTIVITY]. */
const val ACTIVE = "active"

/** The signal `active`: whether the robot is enabled; always true if the log does not show it. */
val ACTIVITY = Signal(ACTIVE, SignalKind.CONDITION)

/** Returns the samples of [ACTIVITY] in [view], where the robot was [enabled]. */
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
