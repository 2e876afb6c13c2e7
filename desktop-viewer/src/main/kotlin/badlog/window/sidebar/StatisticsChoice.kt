package badlog.window.sidebar

import badlog.core.recording.Topic
import badlog.viewer.shown.statistics.Statistic
import badlog.window.state.StateHolder

/**
 * The choices for the table of statistics. Immutable; each transition returns a new one.
 *
 * @property topics the names of the topics, in the order of their columns.
 * @property statistics the statistics of each topic.
 * @property sort the column by which rows are sorted; null for their own order.
 * @property isDescending whether the largest comes first.
 * @property isOverAll whether every log of the folder has a row; otherwise only the open one and the checked ones.
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

    /** Adds or removes [topic]. */
    fun toggled(topic: String): StatisticsChoice = copy(topics = if (topic in topics) topics - topic else topics + topic)

    /** Adds or removes [statistic]. */
    fun toggled(statistic: Statistic): StatisticsChoice =
        copy(statistics = if (statistic in statistics) statistics - statistic else statistics + statistic)

    /** Sorts by [column], or reverses the order if that is the column already. */
    fun sortedBy(column: StatisticsColumn): StatisticsChoice = copy(sort = column, isDescending = sort == column && !isDescending)
}

/** A column of the table of statistics. */
internal sealed interface StatisticsColumn

/** The name of the recording. */
internal data object LabelColumn : StatisticsColumn

/** The time when it was recorded. */
internal data object DateColumn : StatisticsColumn

/** A [statistic] of a [topic]. */
internal data class FigureColumn(val topic: String, val statistic: Statistic) : StatisticsColumn {
    /** Returns its value in [row]; NaN if there is none. */
    fun of(row: StatisticsRow): Double = row.statistics[topic]?.let(statistic::of) ?: Double.NaN

    /** Its unit in [row]; `ul` for none. */
    fun unitIn(row: StatisticsRow): String = statistic.unitOf(row.units[topic] ?: Topic.UNITLESS, row.xUnit)
}

/** The choices for the window's table of statistics. */
internal class SelectedStatistics : StateHolder<StatisticsChoice>(StatisticsChoice())
