package badlog.page.opened

import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.viewer.shown.battery.BatteryAdvice
import badlog.viewer.shown.battery.BatterySeason
import badlog.viewer.shown.battery.BatteryStep
import badlog.viewer.shown.folder.PitLogs
import badlog.viewer.shown.folder.batteryText
import badlog.viewer.shown.folder.durationText
import badlog.viewer.shown.folder.logsOfRobots
import badlog.viewer.shown.folder.verdictText
import badlog.viewer.text.dateText
import kotlinx.browser.document
import org.w3c.dom.HTMLElement

/**
 * What a pit wants to know between two matches, in letters that are read from two meters: the last log, batteries, and the logs before it.
 *
 * @param onOpen called with a log of which a person wants to see what was found.
 */
internal class PitView(private val onOpen: (OpenedLog) -> Unit) {
    val element: HTMLElement = element("section", "pit") { setAttribute("aria-label", "Pit view") }

    /** Whether somebody is just pressing something in it. */
    val isPressed: Boolean get() = element.matches(":active")

    /** Shows the last of [logs], of which some are still to be read if [isReading]. */
    fun show(logs: List<OpenedLog>, isReading: Boolean) {
        val now = element("div", "pit-logs") {
            val pit = PitLogs.of(logsOfRobots(logs, OpenedLog::isOnlyOfLogs))
            if (pit == null) {
                add("p", "", if (isReading) "Reading the first logs…" else "No log yet.")
            } else {
                addLast(pit.last)
                for (line in BatteryAdvice.of(BatterySeason.of(logs)).inPit) add("p", "pit-battery ${lookOf(line.step)}", line.pitText)
                add("div", "pit-before") { pit.before.forEachIndexed { i, log -> addEarlier(log, "pit-$i") } }
            }
        }
        // Somebody may be at one of its buttons while more logs are read.
        if (now.innerHTML == element.firstElementChild?.innerHTML) return
        val focused = document.activeElement?.takeIf { element.contains(it) }?.id
        element.textContent = ""
        element.appendChild(now)
        focused?.let { document.getElementById(it) }?.unsafeCast<HTMLElement>()?.focus()
    }

    private fun HTMLElement.addLast(log: OpenedLog) {
        add("header", "pit-head") {
            add("h2", "", log.title)
            add("p", "unit", listOfNotNull(dateText(log.summary.date.second), durationText(log), batteryText(log)).joinToString(" · "))
        }
        addLog(log, "pit-last") {
            val verdict = log.found?.verdict
            add("strong", "", verdictText(log.found))
            for (sentence in verdict?.sentences.orEmpty()) add("span", "", sentence)
            verdict?.next?.takeIf { it.isNotEmpty() }?.let { add("b", "", "Next: $it") }
        }
    }

    private fun HTMLElement.addEarlier(log: OpenedLog, id: String) = addLog(log, id) {
        add("b", "", log.title)
        add("strong", "", verdictText(log.found))
    }

    private fun HTMLElement.addLog(log: OpenedLog, id: String, build: HTMLElement.() -> Unit) {
        val severity = log.found?.verdict?.severity?.name?.lowercase()
        addButton("pit-log has-$severity", "", "Show what was found in ${log.title}") { onOpen(log) }.apply {
            this.id = id
            build()
        }
    }

    private fun lookOf(step: BatteryStep) = when (step) {
        BatteryStep.USE -> ""
        BatteryStep.RETIRE -> "is-error"
        BatteryStep.CHECK -> "is-warning"
    }
}
