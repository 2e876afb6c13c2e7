package badlog.signals

import badlog.core.analysis.FlagReading
import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.expression.signals.SampleBounds
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.expression.signals.Vocabulary
import badlog.signals.derived.Following
import badlog.signals.derived.quantile
import badlog.signals.pose.PlannedPath
import badlog.signals.vocabulary.FRACTION
import badlog.signals.vocabulary.SignalTopic
import badlog.signals.vocabulary.unitScale
import kotlin.math.abs

/** The name of the x axis among signals. */
const val TIME = "time"

/** The signal `time` if no topic is the x axis, but topics have times of their own. It has every time at which there is a sample. */
val CLOCK = Signal(TIME, SignalKind.NUMBER, "s")

/**
 * The numbers of [signal] times [scale]. If [scale] is null, the samples decide: times are scaled from s, ms or µs to ms ([whole] is NaN), others so
 * that the full value is [whole], whether they are percent or fractions. With a [reading], they are read as true or false. Numbers above [atMost] are
 * not readings, so there is a gap.
 */
data class ScaledSignal(
    val signal: Signal,
    val scale: Double?,
    val whole: Double = 1.0,
    val reading: FlagReading? = null,
    val derived: DerivedSignal? = null,
    val atMost: Double? = null,
)

/** The sum of [summands], usually a single one, under the name [name], in [unit]. For a calculated one, [madeOf] has the topics. */
class NamedSignal(val name: String, val summands: List<ScaledSignal>, unit: String, private val madeOf: List<String>? = null) {
    /** Its entry in a vocabulary. */
    val listed: Signal = Signal(name, kindOf(summands), unit)

    /** The names of its topics. */
    val topics: List<String> get() = madeOf
        ?: summands.map { it.signal }.filter { it !== CLOCK && it !== ACTIVITY && it !== SETTLEMENT }.map { it.name }

    /** The only signal; null for a sum. */
    val only: Signal? get() = summands.singleOrNull()?.signal

    companion object {
        fun of(name: String, signal: Signal): NamedSignal = NamedSignal(name, listOf(ScaledSignal(signal, 1.0)), signal.unit)

        /** Returns the distance from a plan, for a log with this [path]. */
        fun of(path: PlannedPath): NamedSignal =
            NamedSignal(DEVIATION.name, listOf(ScaledSignal(DEVIATION, 1.0)), DEVIATION.unit, path.topics)

        /** Returns [derived] under the name [name]. */
        fun of(name: String, derived: DerivedSignal): NamedSignal = Signal(name, SignalKind.NUMBER, derived.unit).let { signal ->
            NamedSignal(name, listOf(ScaledSignal(signal, 1.0, derived = derived)), derived.unit, derived.topics)
        }

        /** Returns the sum of [topics] as [name]. */
        fun of(name: String, topics: List<SignalTopic>): NamedSignal = NamedSignal(name, topics.map(::scaledOf), topics[0].unit)

        private fun scaledOf(topic: SignalTopic) =
            ScaledSignal(topic.source, topic.scale, wholeIn(topic.unit), topic.reading, atMost = topic.atMost)

        private fun kindOf(summands: List<ScaledSignal>) = when {
            summands.size > 1 -> SignalKind.NUMBER
            summands[0].reading != null -> SignalKind.CONDITION
            else -> summands[0].signal.kind
        }

        /** Returns the full value in [unit]. */
        fun wholeIn(unit: String): Double = if (unit == FRACTION) {
            1.0
        } else if (unitScale(unit, "s") != null) {
            Double.NaN
        } else {
            PERCENT
        }

        private const val PERCENT = 100.0
    }
}

/** The samples of [view], with its topics in [log], under the names of [NamedSignal]s. Each series is made once, however many rules need it. */
class NamedSamples(private val log: Signals, private val view: LogView) {
    private val made = HashMap<List<ScaledSignal>, Series>()

    fun of(named: NamedSignal): Series = made.getOrPut(named.summands) {
        named.summands.singleOrNull()?.let(::scaled) ?: sumOf(named.summands.map(::scaled))
    }

    /**
     * How each part follows its target; several signals are derived from it. The key is the measured topic, or the reference of a device on the CAN
     * bus.
     */
    internal val followings = HashMap<String, Following>()

    /** The pulls that the channels of the power distribution missed while they rested: one list, for all of them. */
    internal val missedPulls = HashMap<String, List<Series>>()

    /** The changes of the channels of the power distribution: one list, for all of them. */
    internal val channelChanges = HashMap<String, List<Double?>>()

    /** The movements of devices that are known by their ids alone; made once. */
    internal var busMotion: BusMotion? = null

    /** Returns the samples of the topic [name] as they were logged. */
    internal fun raw(name: String): Series = log.series(name)

    /** Returns whether the robot was enabled at each of [times], which ascend. Always true if the log does not show it. */
    internal fun enabledAt(times: DoubleArray): BooleanArray {
        val spans = log.enabled ?: return BooleanArray(times.size) { true }
        var next = 0
        return BooleanArray(times.size) { i ->
            while (next < spans.size && spans[next].span.to < times[i]) next++
            next < spans.size && times[i] >= spans[next].span.from
        }
    }

    private val bounds = HashMap<DoubleArray, SampleBounds>()

    /** Returns the bounds of the samples of [series]. */
    fun boundsOf(series: Series): SampleBounds = bounds.getOrPut(series.y) { SampleBounds(series.y) }

    private fun scaled(source: ScaledSignal): Series {
        if (source.derived != null) return source.derived.samples(this)
        if (source.signal === CLOCK) return log.axis
        if (source.signal === ACTIVITY) return activeIn(view, log.enabled.orEmpty())
        if (source.signal === SETTLEMENT) return settledIn(view, log.enabled)
        if (source.signal === DEVIATION) return planDistanceIn(view, log)
        val series = log.series(source.signal.name)
        if (source.reading != null) return flagged(series, source.reading, source.signal)
        val scale = source.scale ?: scaleBySamples(series, source.whole)
        if (source.atMost != null) return plausible(series, scale, source)
        return if (scale == 1.0) series else Series(series.x, DoubleArray(series.size) { series.y[it] * scale })
    }

    private fun flagged(series: Series, reading: FlagReading, signal: Signal): Series {
        val states = if (reading is FlagReading.Text) log.states(signal.name) else emptyList()
        return Series(
            series.x,
            DoubleArray(series.size) {
                val sample = series.y[it]
                if (sample.isNaN()) {
                    sample
                } else if (reading.isSet(sample, states)) {
                    1.0
                } else {
                    0.0
                }
            },
        )
    }

    /** The number of samples left out of each requested topic, since no robot has such values. */
    val implausible: Map<String, Int> get() = leftOut
    private val leftOut = HashMap<String, Int>()

    private fun plausible(series: Series, scale: Double, source: ScaledSignal): Series {
        val most = source.atMost ?: return series
        fun isReading(sample: Double) = abs(sample * scale) <= most && !isBits(sample)
        val count = series.y.count { !it.isNaN() && !isReading(it) }
        if (count > 0) leftOut[source.signal.name] = count
        // A damaged row is one such sample; memory that was never written has no readings.
        val isMemory = series.y.count(::isBits) > MAX_GLITCHES * series.size
        return Series(
            series.x,
            DoubleArray(series.size) { i ->
                if (!isMemory &&
                    isReading(series.y[i])
                ) {
                    series.y[i] * scale
                } else {
                    Double.NaN
                }
            },
        )
    }

    /** Returns whether [sample] is bits of something else, which no sensor reads: the largest and the smallest numbers. */
    private fun isBits(sample: Double) = abs(sample) > MAX_READING || (sample != 0.0 && abs(sample) < MIN_READING)

    private fun scaleBySamples(series: Series, whole: Double): Double {
        if (!whole.isNaN()) return if (isFraction(series)) whole else whole / PERCENT
        val median = quantile(series.y, 0.5)
        return if (median > 0 && median < MAX_SECONDS) {
            1000.0
        } else if (median > MIN_MICROS) {
            1e-3
        } else {
            1.0
        }
    }

    // No robot has a load of so few percent all the time, so such numbers are fractions.
    private fun isFraction(series: Series): Boolean = series.y.all { it.isNaN() || abs(it) <= MAX_FRACTION }

    private fun sumOf(summands: List<Series>): Series {
        val x = summands[0].x
        if (summands.all { it.x === x }) {
            return Series(x, DoubleArray(x.size) { i -> summands.sumOf { it.y[i].orZero() } })
        }
        // Samples hold until the next, so there is a sum at each time at which one changes.
        val times = summands.flatMapTo(HashSet()) { it.x.asIterable() }.toDoubleArray().apply { sort() }
        val sums = DoubleArray(times.size)
        for (series in summands) {
            var next = 0
            for (i in times.indices) {
                while (next < series.size && series.x[next] <= times[i]) next++
                if (next > 0) sums[i] += series.y[next - 1].orZero()
            }
        }
        return Series(times, sums)
    }

    private fun Double.orZero() = if (isNaN()) 0.0 else this

    private companion object {
        const val PERCENT = 100.0

        // No loop takes as little as 0.15 ms, or as long as 0.5 s, half of the time.
        const val MAX_SECONDS = 0.15
        const val MIN_MICROS = 500.0

        const val MAX_READING = 1e12
        const val MIN_READING = 2.3e-308
        const val MAX_GLITCHES = 0.05

        // A controller may demand a little more than the full value.
        const val MAX_FRACTION = 2.0
    }
}

/** The signals of a log, some of them also under other names, with the samples in [samples]. */
class NamedSignals(
    private val log: Signals,
    private val named: Map<String, NamedSignal>,
    override val vocabulary: Vocabulary,
    private val samples: NamedSamples,
) : Signals by log {
    /** The number of samples left out of each topic of the requested signals, since no robot has such values. */
    val implausible: Map<String, Int> get() = samples.implausible

    override fun series(name: String): Series = named[name]?.let(samples::of) ?: log.series(name)

    /** Returns the bounds of the samples of the signal [name]. */
    fun bounds(name: String): SampleBounds = samples.boundsOf(series(name))

    override fun states(name: String): List<String> = log.states(named[name]?.only?.name ?: name)
}
