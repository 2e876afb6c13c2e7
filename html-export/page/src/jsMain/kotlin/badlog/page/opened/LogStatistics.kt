package badlog.page.opened

import badlog.core.recording.Topic
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.viewer.catalog.TopicSummary
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.statistics.Statistic
import badlog.viewer.text.countText
import badlog.viewer.text.exactText
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement
import org.w3c.dom.HTMLSelectElement

/** A table that compares one statistic of each topic between several logs, each over its whole length. */
internal class LogStatistics {
    private var logs = emptyList<OpenedLog>()
    private var statistic = Statistic.MEAN
    private var query = Query("")
    private var limit = PAGE
    private lateinit var table: HTMLElement
    private lateinit var more: HTMLElement

    val element: HTMLElement = element("section", "log-statistics card") {
        setAttribute("aria-label", "Statistics of the checked logs")
        add("div", "log-tools") {
            addChoice()
            addSearch()
        }
        table = add("div", "statistics-scroll").add("table")
        more = addButton("more text-button", "") {
            limit += PAGE
            fill()
        }
        isHidden = true
    }

    /** Shows the statistics of [logs]; hidden if there are none. */
    fun show(logs: List<OpenedLog>) {
        // The list is updated several times a second while logs are read.
        if (logs == this.logs) return
        this.logs = logs
        element.isHidden = logs.isEmpty()
        fill()
    }

    private fun HTMLElement.addChoice() = add("label", "", "Statistic ") {
        val choice = add("select") {
            for (each in Statistic.entries) add("option", "", each.title).setAttribute("value", each.name)
        }.unsafeCast<HTMLSelectElement>()
        choice.id = "statistic"
        choice.value = statistic.name
        choice.onchange = {
            statistic = Statistic.valueOf(choice.value)
            fill()
        }
    }

    private fun HTMLElement.addSearch() {
        val input = add("input", "topic-filter").unsafeCast<HTMLInputElement>()
        input.id = "statistics-search"
        input.type = "search"
        input.placeholder = "Search topics"
        input.setAttribute("aria-label", "Search topics of the statistics")
        input.oninput = {
            query = Query(input.value)
            fill()
        }
    }

    private fun fill() {
        table.textContent = ""
        if (logs.isEmpty()) return
        val topics = logs.map { log -> log.summary.topics.associateBy { it.name } }
        val names = topics.flatMapTo(LinkedHashSet()) { it.keys }.filter { query.isEmpty || query.matches(it) }
        table.add("thead").add("tr") {
            add("th", "", "Topic")
            // Matches of different events may have the same title.
            val areDistinct = logs.distinctBy { it.title }.size == logs.size
            for (log in logs) add("th", "is-number", if (areDistinct) log.title else log.fileName).title = log.path
        }
        table.add("tbody") { for (name in names.take(limit)) addRow(name, topics.map { it[name] }) }
        more.isHidden = names.size <= limit
        more.textContent = "Show more (${countText(names.size - limit)} left)"
    }

    private fun HTMLElement.addRow(name: String, topics: List<TopicSummary?>) = add("tr") {
        val unit = topics.firstNotNullOf { it }.unit
        add("th", "", if (unit == Topic.UNITLESS || unit.isEmpty()) name else "$name [$unit]").setAttribute("scope", "row")
        for (topic in topics) {
            val value = topic?.let { statistic.of(it.statistics) }
            add("td", "is-number", value?.let(statistic::textOf).orEmpty()).title = value?.let(::exactText).orEmpty()
        }
    }

    private companion object {
        /** The number of topics added at a time. */
        const val PAGE = 200
    }
}
