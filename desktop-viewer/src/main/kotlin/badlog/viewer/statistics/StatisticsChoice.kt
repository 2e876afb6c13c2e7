package badlog.viewer.statistics

import badlog.plot.statistics.Statistic
import badlog.recording.Topic
import badlog.viewer.part.Part

/**
 * What the table of statistics shows. Never changes; each transition gives a new one.
 *
 * @property topics the names of the topics, in the order of their columns.
 * @property statistics the figures of each topic.
 * @property sort what the rows are sorted by; null for their own order.
 * @property isDescending whether the largest comes first.
 * @property isOverAll whether every log of the folder has a row; else the open one and those checked.
 */
internal data class StatisticsChoice(
    val topics: List<String> = emptyList(),
    val statistics: Set<Statistic> = setOf(Statistic.MIN, Statistic.MEAN, Statistic.MAX),
    val sort: StatisticsColumn? = null,
    val isDescending: Boolean = false,
    val isOverAll: Boolean = true,
) {
    /** Its columns, from left to right. */
    val columns: List<StatisticsColumn>
        get() = listOf(LabelColumn, DateColumn) +
            topics.flatMap { topic -> Statistic.entries.filter { it in statistics }.map { FigureColumn(topic, it) } }

    /** Adds [topic], or takes it out. */
    fun toggled(topic: String): StatisticsChoice = copy(topics = if (topic in topics) topics - topic else topics + topic)

    /** Adds [statistic], or takes it out. */
    fun toggled(statistic: Statistic): StatisticsChoice =
        copy(statistics = if (statistic in statistics) statistics - statistic else statistics + statistic)

    /** Sorts by [column]; the other way round when it does already. */
    fun sortedBy(column: StatisticsColumn): StatisticsChoice = copy(sort = column, isDescending = sort == column && !isDescending)
}

/** A column of the table of statistics. */
internal sealed interface StatisticsColumn

/** What the recording is called. */
internal data object LabelColumn : StatisticsColumn

/** When it was recorded. */
internal data object DateColumn : StatisticsColumn

/** A [statistic] of a [topic]. */
internal data class FigureColumn(val topic: String, val statistic: Statistic) : StatisticsColumn {
    /** Its figure in [row]; NaN where it has none. */
    fun of(row: StatisticsRow): Double = row.statistics[topic]?.let(statistic::of) ?: Double.NaN

    /** Its unit in [row]; `ul` for none. */
    fun unitIn(row: StatisticsRow): String = statistic.unitOf(row.units[topic] ?: Topic.UNITLESS, row.xUnit)
}

/** What the window's table of statistics shows. */
internal class SelectedStatistics : Part<StatisticsChoice>(StatisticsChoice())
