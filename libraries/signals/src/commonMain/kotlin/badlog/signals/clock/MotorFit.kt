package badlog.signals.clock

import badlog.core.analysis.LogView
import badlog.signals.signalTopicsOf
import badlog.signals.vocabulary.SignalVocabulary
import kotlin.math.abs

/**
 * Returns the relation of the clock of [log], from motor controllers, to the clock of [robot], the robot's log. It is found by the moments in both at
 * which a motor started and stopped. If the robot's log has no motor output, the times when it was enabled are used, since no motor is driven while a
 * robot is disabled. Null if fewer than three moments of a motor, or two of enabling, match.
 *
 * Both logs count from the start of the robot's program, so among several fits with as many moments, the one that moves the log least counts.
 *
 * @param signals the names of the topics in both.
 */
fun motorFit(log: LogView, robot: LogView, signals: SignalVocabulary): ClockFit? {
    val own = outputsOf(log, signals).map(::edgesOf).filter { it.isNotEmpty() }
    val others = outputsOf(robot, signals).map(::edgesOf).filter { it.isNotEmpty() }
    // Names do not show which motor is which: the pair that fits best is taken for the same motor.
    val fits = own.flatMap { one -> others.mapNotNull { ClockFit.ofEdges(one, it, near = 0.0) } }
    fits.filter { it.edges >= MIN_OF_MOTOR }.maxWithOrNull(compareBy({ it.edges }, { -it.error }))?.let { return it }
    val driven = edgesOf(outputsOf(log, signals).flatMap { it })
    return ClockFit.ofEdges(driven, robot.enabledEdges(), near = 0.0)?.takeIf { it.edges >= MIN_OF_ENABLED }
}

/** A time over which something was driven, in s. */
private class Driven(val from: Double, val until: Double)

/** Returns when each of the first [MAX_MOTORS] motors of [log] was driven. */
private fun outputsOf(log: LogView, signals: SignalVocabulary): List<List<Driven>> {
    val known = signalTopicsOf(log, signals)
    val outputs = known.of("motor output").map { it.topic to MIN_OUTPUT }.ifEmpty {
        known.of("motor voltage").map {
            it.topic to
                MIN_VOLTS
        }
    }
    return outputs.take(MAX_MOTORS).mapNotNull { (name, least) ->
        val series = log.recording.topics.find { it.name == name }?.let { log.seriesOf(it).data }?.takeIf { it.isOrdered && it.size > 0 }
        series?.let { drivenIn(it.x, it.y, least, log.secondsPerX) }
    }
}

private fun drivenIn(x: DoubleArray, y: DoubleArray, least: Double, secondsPerX: Double): List<Driven> {
    val driven = ArrayList<Driven>()
    var since = Double.NaN
    for (i in y.indices) {
        if (y[i].isNaN()) continue
        val isDriven = abs(y[i]) >= least
        if (isDriven && since.isNaN()) since = x[i]
        if (!isDriven && !since.isNaN()) {
            driven += Driven(since * secondsPerX, x[i] * secondsPerX)
            since = Double.NaN
        }
    }
    // The end of the last one is unknown.
    if (!since.isNaN()) driven += Driven(since * secondsPerX, Double.POSITIVE_INFINITY)
    return driven
}

/** Returns the starts and ends of [driven]; a short pause, such as when a motor reverses, is ignored. */
private fun edgesOf(driven: List<Driven>): List<EnabledEdge> {
    val edges = ArrayList<EnabledEdge>()
    var until = Double.NaN
    for (one in driven.sortedBy { it.from }) {
        if (until.isNaN() || one.from - until > SHORT_PAUSE) {
            if (until.isFinite()) edges += EnabledEdge(until, false)
            edges += EnabledEdge(one.from, true)
            until = one.until
        } else {
            until = maxOf(until, one.until)
        }
    }
    if (until.isFinite()) edges += EnabledEdge(until, false)
    return edges.take(MAX_EDGES)
}

private const val MIN_OF_MOTOR = 3
private const val MIN_OF_ENABLED = 2

/** As a fraction of the battery voltage, and in V: a motor with less is standing still. */
private const val MIN_OUTPUT = 0.02
private const val MIN_VOLTS = 0.25

/** In seconds. */
private const val SHORT_PAUSE = 0.5
private const val MAX_MOTORS = 16
private const val MAX_EDGES = 60
