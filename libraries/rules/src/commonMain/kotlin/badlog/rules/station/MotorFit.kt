package badlog.rules.station

import badlog.analysis.LogView
import badlog.rules.signal.SignalVocabulary
import badlog.rules.signalTopicsOf
import kotlin.math.abs

/**
 * How the log of motor controllers [log] stands on the clock of the robot's log [robot]: where a motor began to be driven and ceased to be, in
 * both; where the robot's log has no motor's output, by enabled, since no motor is driven while a robot is disabled. Null where fewer than
 * three moments of a motor, or two of enabled, fit.
 *
 * Both count from when the robot's program began, so of several fits with as many moments, the one that moves the log least counts.
 *
 * @param signals what the topics of both are called.
 */
public fun motorFit(log: LogView, robot: LogView, signals: SignalVocabulary): ClockFit? {
    val own = outputsOf(log, signals).map(::edgesOf).filter { it.isNotEmpty() }
    val others = outputsOf(robot, signals).map(::edgesOf).filter { it.isNotEmpty() }
    // Which motor is which, names do not tell: the pair that fits best are one motor.
    val fits = own.flatMap { one -> others.mapNotNull { ClockFit.ofEdges(one, it, near = 0.0) } }
    fits.filter { it.edges >= FEWEST_OF_MOTOR }.maxWithOrNull(compareBy({ it.edges }, { -it.error }))?.let { return it }
    val driven = edgesOf(outputsOf(log, signals).flatMap { it })
    return ClockFit.ofEdges(driven, robot.enabledEdges(), near = 0.0)?.takeIf { it.edges >= FEWEST_OF_ENABLED }
}

/** From when until when something was driven, in s. */
private class Driven(val from: Double, val until: Double)

/** For each of the first [MOST_MOTORS] motors of [log], when it was driven. */
private fun outputsOf(log: LogView, signals: SignalVocabulary): List<List<Driven>> {
    val known = signalTopicsOf(log, signals)
    val outputs = known.of("motor output").map { it.topic to LEAST_OUTPUT }.ifEmpty {
        known.of("motor voltage").map {
            it.topic to
                LEAST_VOLTS
        }
    }
    return outputs.take(MOST_MOTORS).mapNotNull { (name, least) ->
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
    // How long the last one went on, nobody knows.
    if (!since.isNaN()) driven += Driven(since * secondsPerX, Double.POSITIVE_INFINITY)
    return driven
}

/** When what was [driven] began to be and ceased to be; a short pause, as of a motor that turns round, is none. */
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
    return edges.take(MOST_EDGES)
}

private const val FEWEST_OF_MOTOR = 3
private const val FEWEST_OF_ENABLED = 2

/** A share of the battery's voltage, and V: less is what a motor gets that stands still. */
private const val LEAST_OUTPUT = 0.02
private const val LEAST_VOLTS = 0.25

/** In s. */
private const val SHORT_PAUSE = 0.5
private const val MOST_MOTORS = 16
private const val MOST_EDGES = 60
