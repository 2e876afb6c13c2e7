package badlog.signals.battery

import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.Units
import badlog.core.analysis.enabledSpans
import badlog.core.analysis.weightedPercentile
import badlog.signals.NamedSamples
import badlog.signals.NamedSignal
import badlog.signals.vocabulary.SignalTopic
import badlog.signals.vocabulary.SignalTopics

/**
 * The battery of a log over time, in s.
 *
 * @property volts its voltage.
 * @property amps the current that the robot takes from it; null if the log does not show it.
 * @property end the time at which the last samples end.
 */
class BatterySeries private constructor(
    val volts: Series,
    private val amps: Series?,
    val end: Double,
    private val view: LogView,
    private val second: Double,
) {
    /** The spans in which the robot was enabled, in order. */
    internal val enabled: List<Span> by lazy { view.enabledSpans().map { Span(it.span.from / second, it.span.to / second) } }

    /** Returns the resistance of battery and wiring; null if the log does not show it. */
    fun resistance(): Resistance? = amps?.let { resistanceOf(volts, it, end) }

    /** Returns the median voltage within [span]; null if there are samples for less than 1 s. */
    internal fun atRest(span: Span): Double? {
        if (!volts.isOrdered) return null
        val values = DoubleArray(volts.size)
        val weights = DoubleArray(volts.size)
        var size = 0
        forEachHeld(volts) { from, to, volt ->
            // An older voltage is not known any more.
            val held = minOf(to, from + LONGEST_LOAD, span.to) - maxOf(from, span.from)
            // Until there is a first voltage, libraries log 0.
            if (held > 0 && volt > MIN_VOLTS) {
                values[size] = volt
                weights[size++] = held
            }
        }
        return if (weights.sum() < MIN_REST) null else weightedPercentile(values, weights, size, HALF)
    }

    /** Returns whether the voltage was low enough for any roboRIO to cut outputs, for 0.1 s while the robot was enabled. */
    internal fun isLow(): Boolean = volts.isOrdered && enabled.any { span ->
        var low = 0.0
        var longest = 0.0
        forEachHeld(volts) { from, to, volt ->
            low = if (volt in MIN_VOLTS..CUT_VOLTS) low + maxOf(0.0, minOf(to, span.to) - maxOf(from, span.from)) else 0.0
            longest = maxOf(longest, low)
        }
        longest >= CUT_SECONDS
    }

    /** Returns the energy that the robot took from the battery in watt-hours. Null if it is unknown for more than a tenth of the time. */
    internal fun energy(): Double? {
        if (amps == null || !volts.isOrdered || !amps.isOrdered || volts.size == 0 || amps.size == 0) return null
        var joules = 0.0
        var known = 0.0
        var v = -1
        forEachHeld(amps) { from, to, amp ->
            while (v + 1 < volts.size && volts.x[v + 1] <= from) v++
            val volt = if (v < 0) Double.NaN else volts.y[v]
            // A large current does not stay the same for long: logging has stopped.
            val isKnown = amp.isFinite() && volt.isFinite() && (to - from < LONGEST_LOAD || amp < SMALL_LOAD)
            if (isKnown) {
                joules += volt * amp * (to - from)
                known += to - from
            }
        }
        return if (known < MIN_KNOWN * (end - amps.x.first())) null else joules / SECONDS_PER_HOUR
    }

    private inline fun forEachHeld(series: Series, each: (from: Double, to: Double, value: Double) -> Unit) {
        for (i in 0 until series.size) each(series.x[i], if (i + 1 < series.size) series.x[i + 1] else end, series.y[i])
    }

    companion object {
        /** Returns the battery in [view], found among [topics], over x as a time. Null if [view] does not show its voltage. */
        fun of(view: LogView, topics: SignalTopics, samples: NamedSamples): BatterySeries? {
            val volts = topics.of("battery").firstOrNull() ?: return null
            val second = 1 / (Units.secondsIn(view.xAxis.unit) ?: 1.0)
            fun inSeconds(name: String, of: List<SignalTopic>) = samples.of(NamedSignal.of(name, of)).let { series ->
                if (second == 1.0) series else Series(DoubleArray(series.size) { series.x[it] / second }, series.y)
            }
            val current = topics.of("total current").take(1).ifEmpty { topics.summandsOf("total current") }
            return BatterySeries(
                inSeconds("battery", listOf(volts)),
                if (current.isEmpty()) null else inSeconds("total current", current),
                (view.xAxis.range?.endInclusive ?: 0.0) / second,
                view,
                second,
            )
        }
    }
}

/** For a roboRIO 1; a roboRIO 2 cuts outputs below 6.75 V. */
private const val CUT_VOLTS = 6.3

/** In seconds. */
private const val CUT_SECONDS = 0.1
private const val MIN_REST = 1.0
private const val LONGEST_LOAD = 5.0

/** In amperes. */
private const val SMALL_LOAD = 10.0
private const val MIN_KNOWN = 0.9
private const val HALF = 0.5
private const val SECONDS_PER_HOUR = 3600.0
