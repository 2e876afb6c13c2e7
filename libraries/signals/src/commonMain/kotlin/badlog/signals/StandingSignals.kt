package badlog.signals

import badlog.core.analysis.Series
import badlog.signals.derived.heldAt
import badlog.signals.derived.powered
import badlog.signals.derived.scaled
import badlog.signals.derived.standstill
import badlog.signals.derived.timesOf

/**
 * Returns whether a part stands still. Its [topics] are its position, the output of its motor, and its current if it is logged. [full]
 * returns the value of full output.
 */
internal fun standstillOf(topics: List<String>, samples: NamedSamples, full: (Series) -> Double): Series {
    val series = topics.map(samples::raw)
    val times = timesOf(series.take(2))
    val (places, output) = series.map { it.heldAt(times) }
    val driven = scaled(output, 1 / full(series[1]))
    val pushes = series.getOrNull(2)?.let { powered(driven, it.heldAt(times)) } ?: driven
    return standstill(times, places, pushes, samples.enabledAt(times))
}

/** Returns [signals] without the stretches in which several parts stand still. The robot then pushes an obstacle, or is held. */
internal fun standingAlone(signals: List<DerivedSignal>): List<DerivedSignal> = signals.map { own ->
    val others = signals.filter { it.name == own.name && it.device != own.device }
    if (own.name !in STANDING || others.isEmpty()) return@map own
    DerivedSignal(own.name, own.unit, own.device, own.topics) { samples ->
        val stood = own.samples(samples)
        val found by lazy { others.map { it.samples(samples) } }
        withoutStretches(stood) { from, to ->
            found.any { other -> secondsIn(other, stood.x[from] - NEAR_SECONDS, stood.x[to] + NEAR_SECONDS) >= MIN_SECONDS }
        }
    }
}

/** Returns [stood] without a short stretch that lasts until the robot is disabled: the robot may hang on it then. */
internal fun unlessHanging(stood: Series, samples: NamedSamples): Series {
    val isEnabled = samples.enabledAt(stood.x)
    return withoutStretches(stood) { from, to ->
        var end = to
        while (end < stood.size && isEnabled[end] && stood.x[end] - stood.x[to] <= NEAR_SECONDS) end++
        (end == stood.size || !isEnabled[end]) && stood.x[to] - stood.x[from] < HANGING_SECONDS
    }
}

/** Returns [stood] without the stretches of ones, from and to an index, that [isDropped] names. Short gaps do not end one. */
private fun withoutStretches(stood: Series, isDropped: (from: Int, to: Int) -> Boolean): Series {
    val kept = stood.y.copyOf()
    var from = 0
    while (from < kept.size) {
        if (kept[from] > 0) {
            var to = from
            var next = from
            while (++next < kept.size && stood.x[next] - stood.x[to] <= NEAR_SECONDS) if (kept[next] > 0) to = next
            if (isDropped(from, to)) kept.fill(0.0, from, to + 1)
            from = to
        }
        from++
    }
    return Series(stood.x, kept)
}

/** Returns for how long [stood] is 1 between two times. */
private fun secondsIn(stood: Series, from: Double, to: Double): Double =
    (1 until stood.size).filter { stood.y[it] > 0 && stood.x[it - 1] >= from && stood.x[it] <= to }.sumOf { stood.x[it] - stood.x[it - 1] }

private val STANDING = setOf("stall", "standstill")
private const val NEAR_SECONDS = 1.0
private const val MIN_SECONDS = 0.4

/** Robots climb in the last half minute of a match. */
private const val HANGING_SECONDS = 30.0
