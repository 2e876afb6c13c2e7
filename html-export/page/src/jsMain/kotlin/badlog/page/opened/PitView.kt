package badlog.page.opened

import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.showText
import badlog.viewer.shown.battery.BatteryAdvice
import badlog.viewer.shown.battery.BatterySeason
import badlog.viewer.shown.battery.BatteryStep
import badlog.viewer.shown.folder.PitLogs
import badlog.viewer.shown.folder.arrivalText
import badlog.viewer.shown.folder.logsOfRobots
import badlog.viewer.shown.folder.pitEmptiness
import badlog.viewer.shown.folder.pitFacts
import badlog.viewer.shown.folder.verdictText
import badlog.viewer.text.word
import kotlinx.browser.document
import org.w3c.dom.HTMLElement
import org.w3c.dom.asList

/**
 * The view for the pit between two matches, in letters readable from two meters. It shows the last log, batteries, and the logs before it.
 *
 * @param onOpen called with a log to show its worst finding.
 */
internal class PitView(private val onOpen: (OpenedLog) -> Unit) {
    private lateinit var news: HTMLElement
    private var shown = element("div")

    val element: HTMLElement = element("section", "pit") {
        setAttribute("aria-label", "Pit view")
        // Screen readers announce text that appears in an existing element.
        news = add("p", "spoken") { setAttribute("role", "status") }
        appendChild(shown)
    }

    private var isReading: (OpenedLog) -> Boolean = { false }

    /**
     * Shows the last of [logs].
     *
     * @param willRead returns whether a log is read without being opened. Other logs, and a log that is being written, must not hide the
     * last match.
     */
    fun show(logs: List<OpenedLog>, willRead: (OpenedLog) -> Boolean) {
        val now = element("div", "pit-logs") {
            val ofRobots = logsOfRobots(logs, OpenedLog::isOnlyOfLogs)
            val pit = PitLogs.of(ofRobots.filter { it.found != null || willRead(it) }) ?: PitLogs.of(ofRobots)
            if (pit == null) {
                add("p", "", pitEmptiness(logs, isReading = logs.any(willRead)))
            } else {
                isReading = willRead
                addLast(pit.last)
                for (line in BatteryAdvice.of(BatterySeason.of(logs)).inPit) add("p", "pit-battery ${lookOf(line.step)}", line.pitText)
                add("div", "pit-before") { pit.before.forEachIndexed { i, log -> addEarlier(log, "pit-$i") } }
            }
        }
        // A button may have the focus while more logs are read.
        if (now.innerHTML == shown.innerHTML) return
        val focused = document.activeElement?.takeIf { element.contains(it) }?.id
        element.replaceChild(now, shown)
        shown = now
        focused?.let { document.getElementById(it) }?.unsafeCast<HTMLElement>()?.focus()
    }

    /** Announces to screen readers that [log] has arrived. */
    fun announce(log: OpenedLog) = news.showText(arrivalText(log))

    /** Focuses the button of [log], or the first button if there is none. */
    fun focus(log: OpenedLog) {
        val buttons = element.querySelectorAll("button").asList()
        val button = buttons.find { it.unsafeCast<HTMLElement>().getAttribute("data-path") == log.path } ?: buttons.firstOrNull()
        button?.unsafeCast<HTMLElement>()?.focus()
    }

    private fun HTMLElement.addLast(log: OpenedLog) {
        add("header", "pit-head") {
            add("h2", "", log.title)
            add("p", "unit", pitFacts(log))
        }
        addLog(log, "pit-last") {
            val verdict = log.found?.verdict
            add("strong", "", verdictOf(log))
            if (log.found == null && !isReading(log)) add("span", "", "Open it to see what is in it.")
            for (sentence in verdict?.sentences.orEmpty()) add("span", "", sentence)
            verdict?.next?.takeIf { it.isNotEmpty() }?.let { add("b", "", "Next: $it") }
        }
    }

    private fun HTMLElement.addEarlier(log: OpenedLog, id: String) = addLog(log, id) {
        add("b", "", log.title)
        add("strong", "", verdictOf(log))
    }

    private fun verdictOf(log: OpenedLog) = if (log.found == null && !isReading(log)) "Not read yet" else verdictText(log.found)

    private fun HTMLElement.addLog(log: OpenedLog, id: String, build: HTMLElement.() -> Unit) {
        val severity = log.found?.verdict?.severity?.word
        addButton("pit-log has-$severity", "", "Show what was found in ${log.title}") { onOpen(log) }.apply {
            this.id = id
            setAttribute("data-path", log.path)
            build()
        }
    }

    private fun lookOf(step: BatteryStep) = when (step) {
        BatteryStep.USE -> ""
        BatteryStep.RETIRE -> "is-error"
        BatteryStep.CHECK -> "is-warning"
    }
}
