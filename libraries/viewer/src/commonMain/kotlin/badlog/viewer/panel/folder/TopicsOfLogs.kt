package badlog.viewer.panel.folder

import badlog.core.analysis.Units
import badlog.viewer.catalog.ListedLog
import badlog.viewer.panel.Button
import badlog.viewer.panel.Buttons
import badlog.viewer.panel.Cell
import badlog.viewer.panel.Choice
import badlog.viewer.panel.Column
import badlog.viewer.panel.Field
import badlog.viewer.panel.Part
import badlog.viewer.panel.RowGroup
import badlog.viewer.panel.Table
import badlog.viewer.panel.TableRow
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.statistics.Statistic
import badlog.viewer.state.FolderAction
import badlog.viewer.state.TopicsState
import badlog.viewer.text.countText
import badlog.viewer.text.exactText

/** Returns one statistic of each topic in [logs] beside each other, each over its whole log. */
fun topicsOfLogs(logs: List<ListedLog>, state: TopicsState): List<Part> {
    val choices = Statistic.entries.map {
        Button(it.title, FolderAction.MeasureTopics(state.copy(statistic = it)), isOn = it == state.statistic)
    }
    val field = Field("topic-filter", "Search topics of the statistics", text = state.search, isSearch = true) {
        FolderAction.MeasureTopics(state.copy(search = it))
    }
    val query = Query(state.search)
    val topics = logs.map { log -> log.summary.topics.associateBy { it.name } }
    val names = topics.flatMapTo(LinkedHashSet()) { it.keys }.filter { query.isEmpty || query.matches(it) }
    // Matches of different events may have the same title.
    val areDistinct = logs.distinctBy { it.title }.size == logs.size
    val columns = logs.mapIndexed { i, log ->
        Column(if (areDistinct) log.title else log.fileName, log.path, isNumber = true, key = "log $i")
    }
    val rows = names.take(state.limit).map { name ->
        val values = topics.map { of -> of[name]?.let { state.statistic.of(it.statistics) } }
        val unit = topics.firstNotNullOf { it[name] }.unit
        val subject = Cell(if (unit.isEmpty() || Units.isNone(unit)) name else "$name [$unit]")
        val cells = values.map { if (it == null) Cell("") else Cell(state.statistic.textOf(it), exactText(it)) }
        TableRow(name, (listOf(subject) + cells).map(::listOf), name)
    }
    val left = names.size - state.limit
    val more = Button("Show more (${countText(left)} left)", FolderAction.MeasureTopics(state.copy(limit = state.limit + TopicsState.PAGE)))
    return listOfNotNull(
        Choice("statistic", "Statistic", choices),
        field,
        Table("topics", listOf(Column("Topic")) + columns, listOf(RowGroup(rows))),
        if (left > 0) Buttons("more", listOf(more)) else null,
    )
}
