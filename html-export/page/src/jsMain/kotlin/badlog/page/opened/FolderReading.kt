package badlog.page.opened

import badlog.rules.RuleSet
import badlog.rules.toJson
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.LogSummary
import kotlinx.browser.window
import org.w3c.dom.MessageEvent
import org.w3c.dom.Worker

/**
 * Reads the logs of a folder and runs [rules] over them. Uses workers if the browser allows them, otherwise the page, one log after the
 * other.
 *
 * @param cache stores the results.
 * @param next returns the log to read next; null when all have been read.
 * @param onKnown called with a log that has new results.
 * @param onLost called with a log that was not read after all.
 */
internal class FolderReading(
    private val rules: RuleSet,
    private val cache: SummaryCache,
    private val next: () -> OpenedLog?,
    private val onKnown: (OpenedLog) -> Unit,
    private val onLost: (OpenedLog) -> Unit,
) {
    private val workers = ArrayList<Worker>()

    /** The number of calls of [stop], which invalidate work begun before. */
    private var turn = 0
    private var isReadingHere = false

    /** Starts reading; continues if there are more logs, or after [stop]. */
    fun start() {
        repeat((window.navigator.hardwareConcurrency.toInt() - 1).coerceIn(1, MAX_WORKERS) - workers.size) { startWorker() }
        readHereIfAlone()
    }

    private fun readHereIfAlone() {
        if (workers.isEmpty() && !isReadingHere) readHere(turn)
    }

    /** Stops reading; logs that are being read are read again after the next [start]. */
    fun stop() {
        turn++
        isReadingHere = false
        for (worker in workers) worker.terminate()
        workers.clear()
    }

    private fun startWorker() {
        var log = next() ?: return
        val worker = SummaryWorker.start(rules.toJson()) ?: return onLost(log)
        workers += worker
        var hasAnswered = false
        var hasRead = false
        worker.onerror = {
            worker.terminate()
            if (workers.remove(worker)) {
                if (hasAnswered) {
                    onKnown(unreadable(log, "it takes too much memory"))
                    startWorker()
                } else {
                    // Some browsers forbid the worker only after its constructor has returned.
                    onLost(log)
                    readHereIfAlone()
                }
            }
        }
        worker.onmessage = onmessage@{ event: MessageEvent ->
            hasAnswered = true
            val message: dynamic = event.data
            if (message.failure == undefined && message.match != undefined) {
                hasRead = true
                if (message.found != null) cache.keep(log, message)
                log = SummaryMessage.read(message, log)
                onKnown(log)
            } else {
                if (message.failure != null && !hasRead) {
                    // On pages from a disk, WebKit's workers cannot read files.
                    workers -= worker
                    worker.terminate()
                    onLost(log)
                    return@onmessage readHereIfAlone()
                }
                if (message.failure != null) onKnown(unreadable(log, message.failure as String))
                val following = next()
                if (following == null) {
                    workers -= worker
                    worker.terminate()
                } else {
                    log = following
                    worker.postMessage(following.files.toTypedArray())
                }
            }
        }
        worker.postMessage(log.files.toTypedArray())
    }

    private fun readHere(begun: Int) {
        var log = next().also { isReadingHere = it != null } ?: return
        LogExamination(rules).of(log) {
            log = it
            if (turn == begun) onKnown(it)
        }.catch { if (turn == begun) onKnown(unreadable(log, it.message ?: it.toString())) }.then {
            // A timer between two logs lets the page draw and react.
            if (turn == begun) window.setTimeout({ if (turn == begun) readHere(begun) }, 0)
        }
    }

    private fun unreadable(log: OpenedLog, why: String): OpenedLog {
        val trouble = "${log.fileName} cannot be read: $why"
        return log.with(LogSummary.unreadable(log.fileName, log.modified, trouble, Content.UNREADABLE), found = null)
    }
}

/** The maximum number of workers, because each may hold a whole log. */
private const val MAX_WORKERS = 3
