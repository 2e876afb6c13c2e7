package badlog.rules.comparison

import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.StateRuns
import badlog.core.analysis.Units
import badlog.core.analysis.enabledSpans
import badlog.core.analysis.knowsAutonomous
import badlog.expression.LogViewSignals
import badlog.rules.LogEdge
import badlog.rules.has
import badlog.rules.number.ComparedSignal
import badlog.rules.number.DistributedSignal
import badlog.rules.number.Distribution
import badlog.rules.number.LogNumbers
import badlog.rules.number.Measure
import badlog.rules.number.NumberKey
import badlog.rules.number.common
import badlog.rules.number.meanOf
import badlog.rules.number.percentileOf
import badlog.rules.number.timeWithin
import badlog.rules.number.united
import badlog.rules.number.usefulDigits
import badlog.signals.LogShape
import badlog.signals.NamedSamples
import badlog.signals.NamedSignal
import badlog.signals.battery.BatteryUse
import badlog.signals.battery.Resistance
import badlog.signals.battery.batteryUseOf
import badlog.signals.match.MatchKind
import badlog.signals.match.matchOf
import badlog.signals.vocabulary.SignalTopic
import badlog.signals.vocabulary.SignalTopics
import badlog.signals.vocabulary.SignalVocabulary
import kotlin.math.abs

/**
 * Returns the numbers of [view], from the topics that [vocabulary] finds. There are none if it does not show when the robot was enabled, or
 * if that time was too short.
 *
 * @param fileName the name of its file, which may show the match.
 * @param battery the log's facts about the robot's battery.
 */
fun numbersOf(
    view: LogView,
    vocabulary: SignalVocabulary,
    fileName: String,
    battery: BatteryUse? = batteryUseOf(view, vocabulary),
): LogNumbers {
    val shape = LogShape.of(view)
    if (!shape.vocabulary.hasTime) return LogNumbers.NONE
    val topics = shape.topicsOf(vocabulary)
    val kind = vocabulary.matchOf(view.recording, fileName).kind
    return NumberSearch(view.identified(view.title, topics.modes), topics, kind, battery?.resistance).numbers()
}

private class NumberSearch(
    private val view: LogView,
    private val topics: SignalTopics,
    private val kind: MatchKind,
    private val resistance: Resistance?,
) {
    private val samples = NamedSamples(LogViewSignals(view), view)
    private val second = 1 / (Units.secondsIn(view.xAxis.unit) ?: 1.0)
    private val start = view.xAxis.range?.start ?: 0.0
    private val end = view.xAxis.range?.endInclusive ?: 0.0
    private val spans: Map<Measure, List<Span>>
    private val weights = HashMap<Pair<Measure, DoubleArray>, DoubleArray>()
    private val stretches = view.enabledSpans()
    private val beginsEnabled = view.recording.has(LogEdge.START) && stretches.any { it.span.from <= start + second }
    private val endsEnabled = view.recording.has(LogEdge.END) && stretches.any { it.span.to >= end - second / LAST }

    init {
        val enabled = united(stretches.map { it.span }, gap = 0.0)
        val driving = common(enabled, drivenSpans())
        val teleop = stretches.filterNot { it.isTest || it.isAutonomous }
        // If the log does not show autonomous, all of it would count as teleop.
        val isKnown = view.knowsAutonomous
        spans = mapOf(
            Measure.TELEOP to if (isKnown) teleop.map { it.span } else emptyList(),
            Measure.DRIVING to driving,
            Measure.ENABLED to enabled,
        ).filter { (measure, spans) -> spans.sumOf { it.width } >= leastOf(measure) }
    }

    fun numbers(): LogNumbers {
        if (Measure.ENABLED !in spans) return LogNumbers(kind, emptyList(), DoubleArray(0), Double.NaN, beginsEnabled, endsEnabled)
        val keys = ArrayList<NumberKey>()
        val values = ArrayList<Double>()
        for (compared in ComparedSignal.ALL) {
            val (signal, measures) = compared.signal to compared.measures
            for ((topic, named) in namedOf(signal)) {
                val series = samples.of(named)
                if (keys.size >= MAX_NUMBERS || !series.isOrdered || topic.any { it < ' ' }) continue
                for (measure in measures) {
                    if (measure == Measure.ENABLED && Measure.TELEOP in spans && Measure.TELEOP in measures) continue
                    val value = measured(series, measure)
                    if (!value.isFinite()) continue
                    keys += NumberKey(signal, topic, measure, named.listed.unit)
                    values += usefulDigits(value)
                }
            }
        }
        if (resistance != null) {
            keys += NumberKey(NumberKey.RESISTANCE, namedOf("battery").first().first, Measure.RESISTANCE, "mΩ")
            values += usefulDigits(resistance.milliohms)
        }
        val uncertainty = resistance?.uncertainty?.let(::usefulDigits) ?: Double.NaN
        return LogNumbers(kind, keys, values.toDoubleArray(), uncertainty, beginsEnabled, endsEnabled, distributions())
    }

    private fun distributions(): List<Distribution> = DistributedSignal.ALL.mapNotNull { distributed ->
        val named = namedOf(distributed.signal).firstOrNull()?.second ?: return@mapNotNull null
        val series = samples.of(named)
        if (!series.isOrdered) return@mapNotNull null
        distributed.of(series, weightsOf(Measure.ENABLED, series), named.listed.unit, second, leastOf(Measure.ENABLED))
    }

    /** Returns the topics that are [signal], each as a named signal; or their sum, under the name of the first. */
    private fun namedOf(signal: String): List<Pair<String, NamedSignal>> {
        val found = topics.of(signal)
        if (found.isNotEmpty()) return found.map { it.topic to NamedSignal.of(signal, listOf(it)) }
        val summands = topics.summandsOf(signal)
        return if (summands.isEmpty()) emptyList() else listOf(SUM_OF_CHANNELS to NamedSignal.of(signal, summands))
    }

    private fun measured(series: Series, measure: Measure): Double = when (measure) {
        // Until there is a first voltage, libraries log 0.
        Measure.LOWEST -> extreme(series) { one, other -> if (one <= MIN_VOLTS || other < one) other else one }

        Measure.HIGHEST -> extreme(series) { one, other -> maxOf(one, other) }

        Measure.PERCENTILE95 -> percentileOf(series, weightsOf(Measure.ENABLED, series), 0.95, leastOf(Measure.ENABLED))

        else -> if (measure in spans) meanOf(series, weightsOf(measure, series), leastOf(measure)) else Double.NaN
    }

    private fun extreme(series: Series, chosen: (Double, Double) -> Double): Double {
        val weights = weightsOf(Measure.ENABLED, series)
        var found = Double.NaN
        for (i in weights.indices) {
            val value = series.y[i]
            if (weights[i] > 0 && value.isFinite()) found = if (found.isNaN()) value else chosen(found, value)
        }
        return found
    }

    private fun weightsOf(measure: Measure, series: Series): DoubleArray =
        weights.getOrPut(measure to series.x) { timeWithin(spans.getValue(measure), series.x, end) }

    private fun leastOf(measure: Measure) = second * when (measure) {
        Measure.DRIVING -> MIN_DRIVING
        else -> MIN_ENABLED
    }

    /** Returns when a motor of the drivetrain had an output, or one of its modules a speed. */
    private fun drivenSpans(): List<Span> {
        val (driven, least) = topics.of("motor output").filter { isOfDrivetrain(it.topic) } to MIN_OUTPUT
        return if (driven.isNotEmpty()) spansAbove(driven, least) else spansAbove(topics.of("module speed"), MIN_SPEED)
    }

    private fun spansAbove(topics: List<SignalTopic>, least: Double): List<Span> {
        val found = ArrayList<Span>()
        for (topic in topics) {
            val series = samples.of(NamedSignal.of(topic.signal, listOf(topic)))
            if (!series.isOrdered || series.size == 0) continue
            val runs = StateRuns(Series(series.x, DoubleArray(series.size) { if (abs(series.y[it]) > least) 1.0 else 0.0 }), end)
            for (i in runs.states.indices) if (runs.states[i] == 1) found += Span(runs.from[i], runs.to[i])
        }
        return united(found, BRIDGED * second)
    }

    private fun isOfDrivetrain(topic: String) = DRIVETRAIN.any { topic.contains(it, ignoreCase = true) }

    private companion object {
        /** The share of a second before its end in which a log is at its end. */
        const val LAST = 10
        const val MIN_DRIVING = 10.0
        const val MIN_ENABLED = 20.0
        const val MIN_VOLTS = 1.0

        /** For a motor, and for a module in meters per second. */
        const val MIN_OUTPUT = 0.15
        const val MIN_SPEED = 0.5

        /** A robot that reverses is still driving. */
        const val BRIDGED = 0.3
        const val MAX_NUMBERS = 240
        val DRIVETRAIN = listOf("drive", "module", "swerve", "chassis")
    }
}

/** The name of the total current if it is the sum of the channels, not a topic. */
internal const val SUM_OF_CHANNELS = "Total current"
