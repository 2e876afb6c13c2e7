package badlog.rules

import badlog.analysis.Series
import badlog.analysis.XAxis
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind

/** What `time` is where no topic is the x axis, but topics have times of their own: every time at which there is a sample. */
internal val CLOCK = Signal(RuleProgram.TIME, SignalKind.NUMBER, "s")

/** The samples of [CLOCK]. */
internal fun clockOf(xAxis: XAxis): Series {
    val times = DoubleArray(xAxis.clocks.sumOf { it.size })
    var size = 0
    for (clock in xAxis.clocks) {
        clock.copyInto(times, size)
        size += clock.size
    }
    times.sort()
    var kept = 0
    for (time in times) if (kept == 0 || time > times[kept - 1]) times[kept++] = time
    return times.copyOf(kept).let { Series(it, it) }
}
