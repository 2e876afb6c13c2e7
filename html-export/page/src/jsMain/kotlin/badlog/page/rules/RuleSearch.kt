package badlog.page.rules

import badlog.core.analysis.LogView
import badlog.core.analysis.enabledTopics
import badlog.core.recording.Recording
import badlog.rules.LogFindings
import badlog.rules.RuleProgram
import badlog.rules.RuleSet
import badlog.signals.LogShape
import kotlinx.browser.window

/** Runs [rules] on [view], which was read from the file [file]; in a worker if the browser allows one. */
internal class RuleSearch(private val view: LogView, private val rules: RuleSet, private val file: String) {
    /** Starts the rules; later calls either [onFindings] or [onFailure]. */
    fun start(onFindings: (LogFindings) -> Unit, onFailure: (String) -> Unit) =
        RulesWorker.ask(view, rules, file, onFindings, onFailure, onForbidden = { runHere(onFindings, onFailure) })

    /** Runs one rule after another on the page itself; a timer in between lets the page draw and react. */
    private fun runHere(onFindings: (LogFindings) -> Unit, onFailure: (String) -> Unit) {
        val asked = try {
            RuleProgram(rules, LogShape.of(view)).run(view, file, isEverywhere = true).iterator()
        } catch (problem: Throwable) {
            return onFailure(problem.message ?: problem.toString())
        }
        var found = LogFindings(emptyList(), emptyList())
        fun next() {
            try {
                if (asked.hasNext()) {
                    found += asked.next()
                    window.setTimeout({ next() }, 0)
                } else {
                    onFindings(found)
                }
            } catch (problem: Throwable) {
                onFailure(problem.message ?: problem.toString())
            }
        }
        next()
    }
}

/**
 * Returns the recording of [view] with only the samples that [rules] need. The worker receives a copy, and a copy of a whole large log
 * would double its memory. A small log is returned whole, because finding these samples would take longer.
 */
internal fun samplesFor(rules: RuleSet, view: LogView): Recording {
    if (view.recording.topics.sumOf { it.samples.size } < FEW_SAMPLES) return view.recording
    val names = RuleProgram(rules, LogShape.of(view)).topics
    val others = view.enabledTopics() + listOfNotNull(view.xAxis.topic)
    val topics = view.recording.topics.map { topic ->
        if (topic.name in names || topic in others) topic else topic.copy(samples = NO_SAMPLES)
    }
    return view.recording.copy(topics = topics)
}

private const val FEW_SAMPLES = 2_000_000

private val NO_SAMPLES = DoubleArray(0)
