package badlog.page.opened

import badlog.page.dom.add
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.viewer.shown.battery.BatteryAdvice
import badlog.viewer.shown.battery.BatteryColumn
import badlog.viewer.shown.battery.BatterySeason
import org.w3c.dom.HTMLElement

/** The batteries of a folder's logs, with the one to use next; hidden if no log names a battery. */
internal class BatteryTable {
    private var shown = emptyList<List<String>>()

    val element: HTMLElement = element("section", "battery-table card") {
        setAttribute("aria-label", "Batteries")
        isHidden = true
    }

    /** Shows the batteries of [logs]. */
    fun show(logs: List<OpenedLog>) {
        val seasons = BatterySeason.of(logs)
        val columns = BatteryColumn.of(seasons)
        val advised = BatteryAdvice.of(seasons).all.map { it.text }
        val texts = seasons.map { season -> columns.map { it.text(season).orEmpty() } }
        // The list is updated several times a second while logs are read.
        val now = texts + listOf(advised)
        if (now == shown) return
        shown = now
        element.isHidden = seasons.none { it.battery != null }
        element.textContent = ""
        element.add("h2", "", "Batteries")
        for (text in advised) element.add("p", "", text)
        val scroll = element.add("div", "statistics-scroll")
        scroll.tabIndex = 0
        scroll.add("table") {
            add("thead").add("tr") { for (column in columns) addCell("th", column, column.title).title = column.meaning }
            add("tbody") {
                for (row in texts) add("tr") { columns.forEachIndexed { i, column -> addCell(if (i == 0) "th" else "td", column, row[i]) } }
            }
        }
    }

    private fun HTMLElement.addCell(tag: String, column: BatteryColumn, text: String) =
        add(tag, if (column.isNumber) "is-number" else "", text).apply {
            if (tag == "th") setAttribute("scope", if (text == column.title) "col" else "row")
        }
}
