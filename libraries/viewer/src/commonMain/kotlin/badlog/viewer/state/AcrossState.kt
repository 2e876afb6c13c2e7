package badlog.viewer.state

import badlog.viewer.shown.statistics.Statistic

/**
 * A person's choices for the statistics across logs, a table with a row for each log. Immutable; each transition returns a new one.
 *
 * @property topics the names of the topics, in the order of their columns.
 * @property statistics the statistics of each topic.
 * @property sort the column by which rows are sorted; null for their own order.
 * @property isDescending whether the largest comes first.
 * @property isOverAll whether every log of the folder has a row; otherwise only the open one and the checked ones.
 * @property search the search for topics.
 */
data class AcrossState(
    val topics: List<String> = emptyList(),
    val statistics: Set<Statistic> = setOf(Statistic.MIN, Statistic.MEAN, Statistic.MAX),
    val sort: AcrossColumn? = null,
    val isDescending: Boolean = false,
    val isOverAll: Boolean = true,
    val search: String = "",
) {
    /** Its columns of figures, from left to right. */
    val figures: List<AcrossColumn.Figure>
        get() = topics.flatMap { topic -> Statistic.entries.filter { it in statistics }.map { AcrossColumn.Figure(topic, it) } }

    /** Adds or removes [topic]. */
    fun toggled(topic: String): AcrossState = copy(topics = if (topic in topics) topics - topic else topics + topic)

    /** Adds or removes [statistic]. */
    fun toggled(statistic: Statistic): AcrossState =
        copy(statistics = if (statistic in statistics) statistics - statistic else statistics + statistic)

    /** Sorts by [column], or reverses the order if that is the column already. */
    fun sortedBy(column: AcrossColumn): AcrossState = copy(sort = column, isDescending = sort == column && !isDescending)
}

/** A column of the statistics across logs. */
sealed interface AcrossColumn {
    /** The name of the log. */
    data object Label : AcrossColumn

    /** The time when it was recorded. */
    data object Date : AcrossColumn

    /** A [statistic] of a [topic]. */
    data class Figure(val topic: String, val statistic: Statistic) : AcrossColumn
}

/**
 * A person's choices for one statistic of many topics, a table with a column for each log.
 *
 * @property search the search for topics.
 * @property limit the maximum number of topics.
 */
data class TopicsState(val statistic: Statistic = Statistic.MEAN, val search: String = "", val limit: Int = PAGE) {
    companion object {
        /** The number of topics added at a time. */
        const val PAGE: Int = 200
    }
}
