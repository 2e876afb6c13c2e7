package badlog.window.sidebar

import badlog.core.analysis.SeriesStatistics
import badlog.core.analysis.Span
import badlog.core.analysis.statistics
import badlog.core.recording.Topic
import badlog.viewer.choices.range.stateRuns
import badlog.viewer.shown.statistics.ChannelOrder
import badlog.viewer.shown.statistics.Channels
import badlog.viewer.shown.statistics.Histogram
import badlog.viewer.shown.statistics.NamedDifference
import badlog.viewer.shown.statistics.RankedChannel
import badlog.viewer.shown.statistics.StateTime
import badlog.viewer.shown.statistics.Statistic
import badlog.viewer.shown.statistics.timesOf
import badlog.viewer.text.exactText
import badlog.viewer.text.shortNames
import badlog.window.compare.DrawnRecording
import badlog.window.log.DrawableTopic
import badlog.window.log.OpenRecording

/**
 * Statistics of every drawn signal over a part of x.
 *
 * @property part that part, on the x of the open recording.
 * @property xUnit the unit of x, `ul` for none.
 * @property channels the currents of the power distribution's channels, or of motors, by [order]; [what] is their kind.
 * @property opened the name of the signal with the open histogram; null for none.
 */
internal class RangeStatistics(
    val part: NamedSpan,
    val xUnit: String,
    val signals: List<SignalStatistics>,
    val channels: List<RankedChannel> = emptyList(),
    val order: ChannelOrder = ChannelOrder.CHARGE,
    val what: String = "",
    val opened: String? = null,
)

/**
 * Statistics of one signal.
 *
 * @property recording the label of its recording; empty while only one is drawn.
 * @property place the index of that recording among those drawn, also the index of its color.
 * @property cells its displayed values, in order: a name, and a number or a state with its unit.
 * @property histogram the distribution of its values over time; null unless it is open.
 */
internal class SignalStatistics(
    val signal: String,
    val unit: String,
    val recording: String,
    val place: Int,
    val cells: List<StatCell>,
    val histogram: Histogram? = null,
)

/** A name with its value, also [exact] to the last digit, in a separate line if [isWide]. [unit] is `ul` for none. */
internal class StatCell(val name: String, val text: String, val unit: String, val isWide: Boolean = false, val exact: String = text)

/**
 * Returns the statistics of [names] over [part] in each of [drawn]. Also returns how the lines of each of [graphs] differ, and the channels
 * of the first recording, by [order]. The calculation takes a while: call it off the window's thread.
 *
 * @param opened the name of the signal with the open histogram; null for none.
 */
internal fun rangeStatistics(
    drawn: List<DrawnRecording>,
    names: List<String>,
    part: NamedSpan,
    graphs: List<List<String>> = emptyList(),
    order: ChannelOrder = ChannelOrder.CHARGE,
    opened: String? = null,
): RangeStatistics {
    val signals = names.flatMap { name ->
        drawn.mapIndexedNotNull { place, (recording, offset, recordingName) ->
            val signal = recording.signal(name) ?: return@mapIndexedNotNull null
            if (signal.series.size == 0) return@mapIndexedNotNull null
            val parts = part.parts.map { Span(it.from - offset, it.to - offset) }
            val statistics = signal.line.statistics(parts)
            val cells = when {
                signal.hasFigures && signal.states == null -> cellsOf(signal, statistics, recording.view.xAxis.unit)
                else -> cellsOf(recording, signal, statistics, parts)
            }
            val histogram = if (name == opened) Histogram.of(signal.line, parts, statistics) else null
            SignalStatistics(name, signal.unit, if (drawn.size > 1) recordingName else "", place, cells, histogram)
        }
    }
    val xUnit = drawn.firstOrNull()?.recording?.view?.xAxis?.unit.orEmpty()
    val channels = drawn.firstOrNull()?.recording?.let { Channels.of(it.view, it.signalTopics) }
    return RangeStatistics(
        part,
        xUnit,
        signals + graphs.flatMap {
            differencesIn(drawn, it, part)
        },
        channels?.ranked(part.parts, order).orEmpty(),
        order,
        channels?.what.orEmpty(),
        opened,
    )
}

/** Returns how the lines after the first of the graph with [lines] differ from it, in each of [drawn]. */
private fun differencesIn(drawn: List<DrawnRecording>, lines: List<String>, part: NamedSpan): List<SignalStatistics> =
    drawn.flatMapIndexed { place, (recording, offset, recordingName) ->
        val known = lines.mapNotNull { recording.signal(it) }.filter { it.hasFigures }
        val parts = part.parts.map { Span(it.from - offset, it.to - offset) }
        val names = known.map { it.line }.zip(shortNames(known.map { it.name })).toMap()
        NamedDifference.of(known.map { it.line }, parts).map { difference ->
            val texts = difference.texts(recording.view.xAxis, offset)
            val exact = difference.exactTexts(offset)
            val cells = NamedDifference.TITLES.mapIndexed { i, title ->
                StatCell(title, texts[i], Topic.UNITLESS, isWide = i == NamedDifference.TITLES.lastIndex, exact[i])
            }
            val title = "${names[difference.one]} − ${names[difference.other]}"
            SignalStatistics(title, difference.one.unit, if (drawn.size > 1) recordingName else "", place, cells)
        }
    }

private fun cellsOf(signal: DrawableTopic, statistics: SeriesStatistics, xUnit: String): List<StatCell> {
    val shown = if (statistics.mean.isNaN()) listOf(Statistic.SAMPLES, Statistic.GAPS) else Statistic.entries
    return shown.map {
        val value = it.of(statistics)
        StatCell(it.title, it.textOf(value), it.unitOf(signal.unit, xUnit), exact = exactText(value))
    }
}

// Sums of the numbers of states are meaningless.
private fun cellsOf(recording: OpenRecording, signal: DrawableTopic, statistics: SeriesStatistics, parts: List<Span>): List<StatCell> {
    val states = signal.states.orEmpty()
    val axis = recording.view.xAxis
    val times = signal.line.stateRuns().timesOf(states, parts)
    return listOf(
        StatCell("first", stateText(statistics.first, states), Topic.UNITLESS),
        StatCell("last", stateText(statistics.last, states), Topic.UNITLESS),
        StatCell("samples", statistics.count.toString(), Topic.UNITLESS),
    ) + times.take(StateTime.MAX_LISTED).map {
        StatCell("in ${it.state}", "${it.timeText(axis)}, ${it.count}×", Topic.UNITLESS, isWide = true)
    }
}

private fun stateText(value: Double, states: List<String>) = if (value.isNaN()) "–" else states.getOrElse(value.toInt()) { "–" }

/** Returns the statistics as lines of tab-separated cells, for spreadsheets; the first line has the titles of the columns. */
internal fun RangeStatistics.toTsv(): String {
    val columns = signals.flatMap { signal -> signal.cells.map { it.name } }.distinct()
    val head = listOf("topic", "unit", "log", "from", "to") + columns
    val lines = signals.map { signal ->
        val cells = signal.cells.associate { it.name to it.exact }
        listOf(signal.signal, signal.unit, signal.recording, exactText(part.span.from), exactText(part.span.to)) +
            columns.map { cells[it].orEmpty() }
    }
    return (listOf(head) + lines).joinToString("\n", postfix = "\n") { line ->
        line.joinToString("\t") { cell -> cell.replace('\t', ' ').replace('\n', ' ').replace('\r', ' ') }
    }
}
