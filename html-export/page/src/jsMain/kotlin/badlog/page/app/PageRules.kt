package badlog.page.app

import badlog.core.analysis.LogView
import badlog.page.findings.FindingsSection
import badlog.page.rules.RuleSearch
import badlog.page.screen.setRulesState
import badlog.protocol.PageAdditions
import badlog.rules.Finding
import badlog.rules.LogFindings
import badlog.rules.incident.Incident
import badlog.rules.incident.incidentsIn
import badlog.viewer.shown.finding.RuleResults
import kotlinx.browser.window

/**
 * Runs the rules of [additions] over the log and shows their findings in [section], beside those [embedded] in the page.
 *
 * @param file the name of the log's file.
 * @param isShown returns whether the log's page is still shown.
 */
internal class PageRules(
    private val additions: PageAdditions,
    private val embedded: List<Finding>,
    private val file: String,
    private val section: FindingsSection,
    private val isShown: () -> Boolean,
) {
    /** The findings so far; null until the rules have run. */
    var found: LogFindings? = null
        private set

    /** The time at which the last run of the rules ended, on the browser's clock, in ms. */
    var ranAt: Double = 0.0
        private set

    /** Continues with the findings of [left], the page from before the log had grown. */
    fun continueFrom(left: PageSnapshot) {
        left.found?.let(::take)
        ranAt = left.ranAt
    }

    /**
     * Runs the rules on [logged], at the earliest [PAUSE] ms after their last run. A followed log is drawn more often.
     *
     * @param onFound called with the findings and their incidents once they are listed.
     */
    fun start(logged: LogView, onFound: (LogFindings, List<Incident>) -> Unit) {
        if (additions.rules.rules.isEmpty()) return setRulesState("done")
        val pause = if (found == null) 0.0 else ranAt + PAUSE - window.performance.now()
        if (pause <= 0) return run(logged, onFound)
        setRulesState("done")
        window.setTimeout({ if (isShown()) run(logged, onFound) }, pause.toInt())
    }

    private fun run(logged: LogView, onFound: (LogFindings, List<Incident>) -> Unit) {
        RuleSearch(logged, additions.rules, file).start(
            onFindings = onFindings@{ found ->
                if (!isShown()) return@onFindings
                val incidents = take(found)
                ranAt = window.performance.now()
                onFound(found, incidents)
                setRulesState("done")
            },
            onFailure = onFailure@{ reason ->
                if (!isShown()) return@onFailure
                section.fail("The rules could not be run (${reason.trimEnd('.')}); reload the page, or run badlog report on the file.")
                setRulesState("failed")
            },
        )
    }

    private fun take(found: LogFindings): List<Incident> {
        this.found = found
        val incidents = additions.rules.incidentsIn(found.findings, additions.differences)
        section.found = RuleResults(found.findings + embedded, found.skipped, incidents, found.ran)
        return incidents
    }
}

/** The minimum number of milliseconds between two runs over a log that is followed. */
private const val PAUSE = 400
