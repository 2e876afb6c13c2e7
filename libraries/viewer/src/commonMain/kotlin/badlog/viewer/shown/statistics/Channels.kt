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
 * What a channel of the power distribution gave over a part of x; where a log does not show the channels, a motor.
 *
 * @property topic the topic of its current.
 * @property name the shortest name that tells it from the others.
 * @property charge its charge in ampere-hours; null if x is not time.
 * @property share its share of the charge of all, 0 to 1; null if they gave none.
 * @property peak its highest current, in amperes.
 */
class RankedChannel(val topic: String, val name: String, val charge: Double?, val share: Double?, val peak: Double) {
    /** [charge] for people: `0.42 Ah`; `–` for none. */
    val chargeText: String get() = charge?.let { withUnit(numberText(fixedText(it, DECIMALS).toDouble()), "Ah") } ?: NO_NUMBER

    /** [share] in percent; `–` for none. */
    val shareText: String get() = share?.let { withUnit(fixedText(it * PERCENT, 1), "%") } ?: NO_NUMBER

    /** [peak] for people: `62.1 A`. */
    val peakText: String get() = withUnit(numberText(peak), "A")

    /** Returns the number by which it is ranked by [order]: its peak if its charge is not known. */
    fun by(order: ChannelOrder): Double = if (order == ChannelOrder.CHARGE && charge != null) charge else peak

    private companion object {
        const val DECIMALS = 3
        const val PERCENT = 100
    }
}

/**
 * By what channels are ranked.
 *
 * @property title its label.
 * @property hint what it is, for those who do not know.
 */
enum class ChannelOrder(val title: String, val hint: String) {
    /** By charge: what empties the battery. */
    CHARGE("Charge", "Channels by charge: what empties the battery"),

    /** By the highest current: what makes its voltage drop. */
    PEAK("Peak", "Channels by their highest current: what makes the voltage drop"),
}

/**
 * The channels of a log, in whose [view] they are found.
 *
 * @property what what they are: `Channel`, or `Motor` where a log does not show the channels.
 */
class Channels private constructor(private val view: LogView, private val lines: List<Pair<GraphSeries, Double>>, val what: String) {
    private val names = shortNames(lines.map { (line, _) -> line.topic.name })

    /** The names of their topics. */
    val topics: Set<String> = lines.mapTo(HashSet()) { (line, _) -> line.topic.name }

    /** Returns those that gave anything within [parts] of x, by [order], the largest first. */
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
        /** Returns the channels of [view], whose topics [topics] knows; or else its motors. */
        fun of(view: LogView, topics: SignalTopics): Channels {
            val channels = topics.of("channel current")
            // A log may have them twice, from two libraries.
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

        /** The name of the channel [topic] without its number. */
        private fun listOfName(topic: String) = topic.filterNot { it.isDigit() }

        private const val SECONDS_PER_HOUR = 3600.0
    }
}
