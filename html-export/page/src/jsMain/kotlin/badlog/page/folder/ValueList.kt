package badlog.page.folder

import badlog.core.recording.PathName
import badlog.core.recording.Value
import badlog.page.dom.add
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.viewer.shown.search.Query
import org.w3c.dom.HTMLElement

/** The values of a folder by name. */
internal class ValueList(values: List<Value>) {
    private val rows = ArrayList<Pair<HTMLElement, String>>()

    val element: HTMLElement = element("dl", "values card") {
        for (value in values) {
            val row = add("div", "value-row") {
                setAttribute("data-name", value.name)
                add("dt", "", PathName.baseNameOf(value.name)).title = value.name
                add("dd", if (value.text.isEmpty()) "is-empty" else "", value.text.ifEmpty { "empty" })
            }
            rows += row to "${value.name} ${value.text}".lowercase()
        }
    }

    /** Shows the values that match [query], and returns their number. */
    fun filter(query: Query): Int {
        var found = 0
        for ((row, haystack) in rows) {
            row.isHidden = !query.matchesLowercase(haystack)
            if (!row.isHidden) found++
        }
        element.isHidden = found == 0
        return found
    }
}
