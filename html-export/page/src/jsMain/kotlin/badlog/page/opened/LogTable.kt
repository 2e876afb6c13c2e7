package badlog.page.opened

import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.focusInPlace
import badlog.page.dom.isHidden
import badlog.viewer.shown.folder.Listing
import badlog.viewer.shown.folder.LogColumn
import badlog.viewer.shown.folder.foundLines
import badlog.viewer.shown.folder.isNearBrownout
import badlog.viewer.shown.folder.problemSentence
import badlog.viewer.shown.folder.problemSeverity
import badlog.viewer.text.countText
import badlog.viewer.text.word
import kotlinx.browser.document
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement

/**
 * A table of logs, with the columns of the window except [UNSEEN].
 *
 * @param onSort called with the column by which to sort.
 * @param onCheck called when a log is checked or unchecked.
 * @param onOpen called with the log to open, and whether to show its worst finding.
 */
internal class LogTable(
    private val onSort: (LogColumn) -> Unit,
    private val onCheck: (OpenedLog, Boolean) -> Unit,
    private val onOpen: (OpenedLog, showsWorst: Boolean) -> Unit,
) {
    private lateinit var head: HTMLElement
    private lateinit var body: HTMLElement
    private lateinit var more: HTMLElement
    private var limit = PAGE
    private var showAgain = {}

    val element: HTMLElement = element("div", "log-table card") {
        add("table") {
            head = add("thead").add("tr")
            body = add("tbody")
        }
        more = addButton("more text-button", "") {
            limit += PAGE
            showAgain()
        }
    }

    /** Whether a person is pressing something in the table. */
    val isPressed: Boolean get() = element.matches(":active")

    /** Shows [listing] and checks the logs at the paths [checked]. */
    fun show(listing: Listing<OpenedLog>, checked: Set<String>) {
        showAgain = { show(listing, checked) }
        // The keyboard's focus stays in place, although its row is recreated.
        val focused = (document.activeElement?.takeIf { element.contains(it) })?.id
        val columns = LogColumn.entries.filter { it !in UNSEEN && (it in ALWAYS || listing.entries.any(it.has)) }
        head.textContent = ""
        head.add("th") { add("span", "spoken", "Compare") }
        for (column in columns) head.addTitle(column, listing)
        body.textContent = ""
        var event: String? = null
        listing.visible.take(limit).forEachIndexed { i, log ->
            val own = log.summary.match.event
            if (listing.groupsEvents && (i == 0 || own != event)) body.addEvent(own, listing, columns.size + 1)
            event = own
            body.addRow(log, columns, log.path in checked)
        }
        more.isHidden = listing.visible.size <= limit
        more.textContent = "Show more (${countText(listing.visible.size - limit)} left)"
        focused?.let { document.getElementById(it) }?.focusInPlace()
    }

    private fun HTMLElement.addTitle(column: LogColumn, listing: Listing<OpenedLog>) = add("th", if (column.isNumber) "is-number" else "") {
        val isSorted = column == listing.column
        val order = if (listing.isDescending) "descending" else "ascending"
        if (isSorted) setAttribute("aria-sort", order)
        val arrow = if (listing.isDescending) " ↓" else " ↑"
        addButton("text-button", column.title + if (isSorted) arrow else "", "Sort by ${column.title}") { onSort(column) }.id =
            "sort-${column.name}"
    }

    private fun HTMLElement.addEvent(event: String?, listing: Listing<OpenedLog>, columns: Int) = add("tr", "event-group").add("th") {
        setAttribute("colspan", "$columns")
        setAttribute("scope", "rowgroup")
        val logs = listing.visible.count { it.summary.match.event == event }
        add("span", "", event ?: "No event")
        add("span", "unit", " ${countText(logs, "log")}")
    }

    private fun HTMLElement.addRow(log: OpenedLog, columns: List<LogColumn>, isChecked: Boolean) =
        add("tr", if (log.isGray) "is-gray" else "") {
            setAttribute("data-path", log.path)
            addEventListener("click", { if (it.target.asDynamic().closest("button, input") == null) onOpen(log, false) })
            add("td") {
                if (!log.isReadable) return@add
                val box = add("input").unsafeCast<HTMLInputElement>()
                box.type = "checkbox"
                box.id = "check:${log.path}"
                box.checked = isChecked
                box.setAttribute("aria-label", "Compare ${log.fileName}")
                box.addEventListener("change", { onCheck(log, box.checked) })
            }
            for (column in columns) {
                add("td", if (column.isNumber) "is-number" else "") {
                    setAttribute("data-column", column.name)
                    fill(log, column)
                }
            }
        }

    private fun HTMLElement.fill(log: OpenedLog, column: LogColumn) {
        val shown = column.text(log).orEmpty()
        when (column) {
            LogColumn.FILE -> addButton("text-button", shown, log.path) { onOpen(log, false) }.id = "open:${log.path}"

            LogColumn.FINDINGS -> {
                val worst = log.found?.worst
                if (worst == null) {
                    textContent = when {
                        log.isGray -> log.summary.content.saying

                        // It is read when a person opens it.
                        !log.isHere -> ""

                        else -> shown
                    }
                } else {
                    val look = "text-button is-${worst.word}"
                    addButton(look, shown, foundLines(log)) { onOpen(log, true) }.id = "found:${log.path}"
                }
            }

            LogColumn.PROBLEMS -> {
                val look = log.problemSeverity?.let { "is-${it.word}" }.orEmpty() + if (log.isReadable) "" else " is-unreadable"
                add("span", look, shown).title = problemSentence(log)
            }

            LogColumn.BATTERY -> {
                add("span", if (log.isNearBrownout) "is-error" else "", shown)
            }

            else -> textContent = shown
        }
    }

    private companion object {
        /** The number of rows added at a time. */
        const val PAGE = 300

        /** The columns for which a page has no room. */
        val UNSEEN = setOf(LogColumn.SAMPLES, LogColumn.ALLIANCE)

        /** The columns that are shown even while they are empty. */
        val ALWAYS = setOf(LogColumn.DURATION, LogColumn.FINDINGS)
    }
}
