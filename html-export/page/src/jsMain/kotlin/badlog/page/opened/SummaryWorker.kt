package badlog.page.opened

import badlog.page.dom.json
import badlog.page.dom.startWorker
import badlog.rules.RuleSet
import badlog.rules.fromJson
import org.w3c.dom.DedicatedWorkerGlobalScope
import org.w3c.dom.MessageEvent
import org.w3c.dom.Worker
import org.w3c.files.File

/**
 * The worker that examines the logs of a folder, one after the other. Its script is the page's own; its name identifies it.
 *
 * The page sends the rules as JSON, then the files of a log. The worker answers with its results, see [SummaryMessage], and last for each
 * log with an object that contains only `failure`, null if the log could be read.
 */
internal object SummaryWorker {
    private const val NAME = "summaries"

    /** Whether this script runs in it. */
    val isHere: Boolean get() = js("self.name") == NAME

    /** Starts a worker with [rules] as JSON; null if no worker may run. */
    fun start(rules: String): Worker? = startWorker(NAME)?.also { it.postMessage(rules) }

    /** Answers the page's messages, in the worker. */
    fun run() {
        val page = js("self").unsafeCast<DedicatedWorkerGlobalScope>()
        var examination = LogExamination(RuleSet.NONE)
        page.onmessage = { event: MessageEvent ->
            val message: dynamic = event.data
            if (jsTypeOf(message) == "string") {
                examination = LogExamination(checkNotNull(RuleSet.fromJson(message as String)))
            } else {
                val log = OpenedLog(message.unsafeCast<Array<File>>().toList())
                examination.of(log) { page.postMessage(SummaryMessage.of(it)) }.then(
                    { page.postMessage(json("failure" to null)) },
                    { page.postMessage(json("failure" to (it.message ?: it.toString()))) },
                )
            }
        }
    }
}
