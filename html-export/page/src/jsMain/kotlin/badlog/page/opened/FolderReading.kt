package badlog.page.opened

import badlog.page.dom.startWorker
import badlog.rules.RuleSet
import badlog.rules.toJson
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.LogSummary
import kotlinx.browser.window
import org.w3c.dom.MessageEvent
import org.w3c.dom.Worker
import kotlin.js.Promise

/**
 * Reads the logs of a folder and runs [rules] over them: in workers if the browser allows them, otherwise on the page, one log after the
 * other.
 *
 * @param next returns the log to read next; null when all have been read.
 * @param onKnown called with a log of which more is known.
 */
internal class FolderReading(private val rules: RuleSet, private val next: () -> OpenedLog?, private val onKnown: (OpenedLog) -> Unit) {
    private val workers = ArrayList<Worker>()
    private var isOver = false

    /** Starts, or goes on after [stop]. */
    fun start() {
        isOver = false
        val json = rules.toJson()
        repeat((window.navigator.hardwareConcurrency.toInt() - 1).coerceIn(1, MAX_WORKERS)) {
            SummaryWorker.start(json)?.let {
                workers += it
                readIn(it)
            }
        }
        if (workers.isEmpty()) readHere()
    }

    /** Stops reading; logs that are being read are read again after the next [start]. */
    fun stop() {
        isOver = true
        for (worker in workers) worker.terminate()
        workers.clear()
    }

    private fun readIn(worker: Worker) {
        var log = next() ?: return worker.terminate()
        worker.onerror = {
            worker.terminate()
            workers -= worker
            // Some browsers forbid the worker only after its constructor has returned.
            if (workers.isEmpty() && !isOver) readHere(log)
        }
        worker.onmessage = { event: MessageEvent ->
            val message: dynamic = event.data
            when {
                isOver -> Unit

                message.failure == undefined && message.match != undefined -> {
                    log = SummaryMessage.read(message, log)
                    onKnown(log)
                }

                else -> {
                    if (message.failure != null) onKnown(unreadable(log, message.failure as String))
                    next()?.let {
                        log = it
                        worker.postMessage(it.files.toTypedArray())
                    }
                }
            }
        }
        worker.postMessage(log.files.toTypedArray())
    }

    private fun readHere(first: OpenedLog? = next()) {
        var log = first ?: return
        LogExamination(rules).of(log) {
            log = it
            if (!isOver) onKnown(it)
        }.catch { if (!isOver) onKnown(unreadable(log, it.message ?: it.toString())) }.then {
            if (!isOver) {
                // A timer between two logs lets the page draw and react.
                window.setTimeout({ readHere() }, 0)
            }
        }
    }

    private fun unreadable(log: OpenedLog, why: String): OpenedLog {
        val trouble = "${log.fileName} cannot be read: $why"
        return log.with(LogSummary.unreadable(log.fileName, log.modified, trouble, Content.UNREADABLE), found = null)
    }

    private companion object {
        /** Each may hold a whole log. */
        const val MAX_WORKERS = 3
    }
}
