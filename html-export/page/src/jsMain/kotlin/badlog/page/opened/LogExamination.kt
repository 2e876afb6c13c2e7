package badlog.page.opened

import badlog.core.analysis.LogView
import badlog.page.reading.LogFileReader
import badlog.rules.RuleSet
import badlog.rules.comparison.numbersOf
import badlog.rules.over
import badlog.signals.overItsTime
import badlog.signals.withSignals
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.LogSummary
import badlog.viewer.catalog.foundIn
import kotlin.js.Promise

/** Reads logs for lists, and runs [rules] over them. Used in a worker, or on the page if there is none. */
internal class LogExamination(private val rules: RuleSet) {
    /**
     * Examines [log]. [onKnown] is called with its summary and, unless lists show it in gray, again with its findings. The promise is
     * rejected if the log cannot be read.
     */
    fun of(log: OpenedLog, onKnown: (OpenedLog) -> Unit): Promise<Unit> = LogFileReader(log.files) {}.read().then { read ->
        val name = log.fileName
        val view = LogView.of(read.overItsTime()).withSignals(rules.signals, name)
        val summary = LogSummary.of(view, rules.signals, name, log.modified, OpenedLog.isOnlyOfLogs(name))
        val known = log.with(summary, found = null)
        onKnown(known)
        if (!known.isGray) onKnown(examined(known, view))
    }

    private fun examined(log: OpenedLog, view: LogView) = try {
        val found = rules.foundIn(rules.over(view, log.fileName, isEverywhere = true).findings, key = 0)
        log.with(log.summary, found, numbersOf(view, rules.signals, log.fileName, log.summary.battery))
    } catch (problem: Throwable) {
        console.error(problem)
        log.with(log.summary, FindingSummary(0, null))
    }
}
