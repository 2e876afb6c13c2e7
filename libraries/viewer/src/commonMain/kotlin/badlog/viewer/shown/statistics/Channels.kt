package badlog.viewer.shown.statistics

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.analysis.Units
import badlog.core.analysis.statistics
import badlog.signals.vocabulary.SignalTopics
import badlog.viewer.text.NO_NUMBER
import badlog.viewer.text.fixedText
import badlog.viewer.text.numberText
import badlog.viewer.text.shortNames
import badlog.viewer.text.withUnit

/**
 * The load of a power distribution channel over a part of x. If a log does not show the channels, it is the load of a motor.
 *
 * @property topic the topic of the current.
 * @property name the shortest name that distinguishes it from the others.
 * @property charge the charge in ampere-hours; null if x is not time.
 * @property share the fraction of the charge of all channels, 0 to 1; null if that is 0 or unknown.
 * @property peak the highest current, in amperes.
 */
class RankedChannel(val topic: String, val name: String, val charge: Double?, val share: Double?, val peak: Double) {
    /** The displayed [charge]: `0.42 Ah`; `–` if unknown. */
    val chargeText: String get() = charge?.let { withUnit(numberText(fixedText(it, DECIMALS).toDouble()), "Ah") } ?: NO_NUMBER

    /** The displayed [share] in percent; `–` if unknown. */
    val shareText: String get() = share?.let { withUnit(fixedText(it * PERCENT, 1), "%") } ?: NO_NUMBER

    /** The displayed [peak]: `62.1 A`. */
    val peakText: String get() = withUnit(numberText(peak), "A")

    /** Returns the number for a ranking by [order]; the peak if the charge is unknown. */
    fun by(order: ChannelOrder): Double = if (order == ChannelOrder.CHARGE && charge != null) charge else peak
}

/**
 * The quantity by which channels are ranked.
 *
 * @property title the label.
 * @property hint an explanation for beginners.
 */
enum class ChannelOrder(val title: String, val hint: String) {
    /** The charge, which empties the battery. */
    CHARGE("Charge", "Channels by charge: what empties the battery"),

    /** The highest current, which makes the voltage drop. */
    PEAK("Peak", "Channels by their highest current: what makes the voltage drop"),
}

/**
 * The channels of a log; [view] has their topics.
 *
 * @property what the kind of channels: `Channel`, or `Motor` if a log does not show the channels.
 */
class Channels private constructor(private val view: LogView, private val lines: List<Pair<GraphSeries, Double>>, val what: String) {
    private val names = shortNames(lines.map { (line, _) -> line.topic.name })

    /** The names of the channels' topics. */
    val topics: Set<String> = lines.mapTo(HashSet()) { (line, _) -> line.topic.name }

    /** Returns the channels with any current within [parts] of x, by [order], the largest first. */
    fun ranked(parts: List<Span>, order: ChannelOrder): List<RankedChannel> {
        val hours = Units.secondsIn(view.xAxis.unit)?.let { it / SECONDS_PER_HOUR }
        val statistics = lines.map { (line, _) -> line.statistics(parts) }
        val charges = lines.indices.map { i -> hours?.let { statistics[i].integral * lines[i].second * it }?.takeIf { it.isFinite() } }
        val total = charges.sumOf { it ?: 0.0 }
        val channels = lines.indices.filter { statistics[it].max * lines[it].second > 0 }.map { i ->
            val share = charges[i]?.let { if (total > 0) it / total else null }
            RankedChannel(lines[i].first.topic.name, names[i], charges[i], share, statistics[i].max * lines[i].second)
        }
        return channels.sortedByDescending { it.by(order) }
    }

    companion object {
        /** Returns the channels of [view], according to [topics]; without channels, its motors. */
        fun of(view: LogView, topics: SignalTopics): Channels {
            val channels = topics.of("channel current")
            // Two libraries may log the same channels.
            val first = channels.firstOrNull()?.let { listOfName(it.topic) }
            val found = channels.filter { listOfName(it.topic) == first }.ifEmpty { topics.of("motor current") }
            val byName = view.recording.topics.associateBy { it.name }
            return Channels(
                view,
                found.mapNotNull { topic ->
                    byName[topic.topic]?.let { view.seriesOf(it) to (topic.scale ?: 1.0) }
                },
                if (channels.isEmpty()) "Motor" else "Channel",
            )
        }

        /** Returns the name of the channel [topic] without its number. */
        private fun listOfName(topic: String) = topic.filterNot { it.isDigit() }

        private const val SECONDS_PER_HOUR = 3600.0
    }
}

private const val DECIMALS = 3
private const val PERCENT = 100
