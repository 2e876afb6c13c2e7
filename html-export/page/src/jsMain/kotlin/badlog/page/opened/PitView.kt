package badlog.page.opened

import badlog.page.dom.add
import badlog.page.dom.element
import badlog.page.dom.showText
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.viewer.panel.folder.pitPanel
import badlog.viewer.shown.battery.BatteryAdvice
import badlog.viewer.shown.folder.PitLogs
import badlog.viewer.shown.folder.arrivalText
import badlog.viewer.shown.folder.logsOfRobots
import badlog.viewer.shown.folder.pitEmptiness
import org.w3c.dom.HTMLElement
import org.w3c.dom.asList

/** The view for the pit between two matches, see [pitPanel]; [nodes] makes its content. */
internal class PitView(private val nodes: PartNodes) {
    private lateinit var news: HTMLElement
    private lateinit var content: HTMLElement

    val element: HTMLElement = element("section", "pit") {
        setAttribute("aria-label", "Pit view")
        // Screen readers announce text that appears in an existing element.
        news = add("p", "spoken") { setAttribute("role", "status") }
        content = add("div", "pit-logs")
    }

    /**
     * Shows the last of [logs], with [advice] on batteries.
     *
     * @param willRead returns whether a log is read without being opened. Other logs, and a log that is being written, must not hide the
     * last match.
     */
    fun show(logs: List<OpenedLog>, advice: BatteryAdvice, willRead: (OpenedLog) -> Boolean) {
        val ofRobots = logsOfRobots(logs, OpenedLog::isOnlyOfLogs)
        val pit = PitLogs.of(ofRobots.filter { it.found != null || willRead(it) }) ?: PitLogs.of(ofRobots)
        val parts = pitPanel(pit, pitEmptiness(logs, isReading = logs.any(willRead)), advice, willRead = willRead)
        content.patch(nodes.of(parts))
    }

    /** Announces to screen readers that [log] has arrived. */
    fun announce(log: OpenedLog) = news.showText(arrivalText(log))

    /** Focuses the button of [log], or the first button if there is none. */
    fun focus(log: OpenedLog) {
        val buttons = element.querySelectorAll("button").asList()
        val button = buttons.find { it.unsafeCast<HTMLElement>().getAttribute("data-path") == log.path } ?: buttons.firstOrNull()
        button?.unsafeCast<HTMLElement>()?.focus()
    }
}
