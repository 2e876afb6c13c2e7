package badlog.page.rules

import badlog.core.analysis.LogView
import badlog.page.dom.PageEvents
import badlog.page.dom.json
import badlog.page.dom.startWorker
import badlog.page.reading.RecordingMessage
import badlog.protocol.logFindingsOf
import badlog.protocol.toJson
import badlog.rules.LogFindings
import badlog.rules.RuleSet
import badlog.rules.fromJson
import badlog.rules.over
import badlog.rules.toJson
import org.w3c.dom.DedicatedWorkerGlobalScope
import org.w3c.dom.MessageEvent

/**
 * The worker that runs rules, so that the page stays responsive. Its script is the page's own; its name identifies it.
 *
 * The page sends an object with `recording`, `rules` as JSON, and `file`. The worker answers with the findings as JSON, or with an
 * object that has a `failure`.
 */
internal object RulesWorker {
    private const val NAME = "rules"

    /** Whether this script runs in the worker. */
    val isHere: Boolean get() = js("self.name") == NAME

    /**
     * Starts the worker for [view], which was read from the file [file].
     *
     * @param onFindings receives the findings of [rules].
     * @param onFailure receives the reason why there are none.
     * @param onForbidden called if no worker can run, as for pages on a disk in some browsers.
     */
    fun ask(
        view: LogView,
        rules: RuleSet,
        file: String,
        onFindings: (LogFindings) -> Unit,
        onFailure: (String) -> Unit,
        onForbidden: () -> Unit,
    ) {
        val worker = startWorker(NAME) ?: return onForbidden()
        PageEvents.onEnd(worker::terminate)
        worker.onerror = {
            worker.terminate()
            onForbidden()
        }
        worker.onmessage = { event: MessageEvent ->
            worker.terminate()
            val answer: dynamic = event.data
            val found = if (jsTypeOf(answer) == "string") logFindingsOf(answer as String) else null
            if (found == null) onFailure(answer.failure as String? ?: "their result cannot be read") else onFindings(found)
        }
        try {
            val recording = RecordingMessage.of(samplesFor(rules, view))
            worker.postMessage(json("recording" to recording, "rules" to rules.toJson(), "file" to file))
        } catch (_: Throwable) {
            // There is not enough memory for a copy; the page itself needs none.
            worker.terminate()
            onForbidden()
        }
    }

    /** Answers the page's messages, in the worker. */
    fun run() {
        val page = js("self").unsafeCast<DedicatedWorkerGlobalScope>()
        page.onmessage = { event: MessageEvent ->
            val question: dynamic = event.data
            try {
                val rules = checkNotNull(RuleSet.fromJson(question.rules as String))
                val view = LogView.of(RecordingMessage.read(question.recording))
                page.postMessage(rules.over(view, question.file as String, isEverywhere = true).toJson())
            } catch (problem: Throwable) {
                page.postMessage(json("failure" to (problem.message ?: problem.toString())))
            }
        }
    }
}
