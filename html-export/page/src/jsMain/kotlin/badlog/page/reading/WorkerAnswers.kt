package badlog.page.reading

import org.w3c.dom.MessageEvent
import org.w3c.dom.Worker
import org.w3c.files.Blob

/**
 * Handlers for the answers of a worker that reads a log, see [ReadingWorker].
 *
 * @property onProgress receives the fraction that is done.
 * @property onRead receives the log; the worker has ended.
 * @property onFailure receives the reason why the log cannot be read.
 * @property onRefusal called if the browser does not run the worker at all.
 * @property onMore called when the worker can accept another piece.
 */
internal class WorkerAnswers(
    val onProgress: (Double) -> Unit,
    val onRead: (ReadLog) -> Unit,
    val onFailure: (Throwable) -> Unit,
    val onRefusal: () -> Unit,
    val onMore: () -> Unit = {},
)

/** Passes the messages of this worker to [answers]. */
internal fun Worker.receive(answers: WorkerAnswers) {
    var hasAnswered = false
    onerror = { event ->
        terminate()
        // Some browsers forbid the worker only after its constructor has returned.
        if (hasAnswered) answers.onFailure(Error(event.asDynamic().message as? String)) else answers.onRefusal()
    }
    onmessage = { event: MessageEvent ->
        hasAnswered = true
        val message: dynamic = event.data
        when {
            message == ReadingWorker.MORE -> answers.onMore()

            jsTypeOf(message) == "number" -> answers.onProgress(message as Double)

            else -> {
                terminate()
                if (message.failure != undefined) {
                    answers.onFailure(Error(message.failure as String))
                } else {
                    val made = message.made.unsafeCast<Blob?>()
                    answers.onRead(ReadLog(RecordingMessage.read(message), message.isDamaged as Boolean, made))
                }
            }
        }
    }
}
