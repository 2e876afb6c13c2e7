package badlog.page.reading

import badlog.core.recording.Problem
import badlog.core.recording.Recording
import badlog.page.dom.startWorker
import badlog.page.embedded.About
import badlog.page.embedded.Base64Text
import kotlinx.browser.window
import org.w3c.dom.Element
import org.w3c.dom.Worker
import kotlin.js.Promise

/**
 * Reads the embedded recording, in a worker if the browser allows one, otherwise on the page in slices.
 *
 * @param onProgress receives the fraction of the bytes that has been read, 0 to 1.
 */
internal class Reading(private val about: About, private val element: Element, private val onProgress: (Double) -> Unit) {
    /** Starts, and promises the recording. */
    fun start(): Promise<ReadLog> = Promise { resolve, reject ->
        val worker = startWorker()
        val finish = { read: ReadLog -> resolve(ReadLog(withCut(read.recording), read.isDamaged)) }
        if (worker == null) readHere(finish, reject) else readIn(worker, finish, reject)
    }

    // Only the exporter, which inflated the whole file, knows whether the stream was complete.
    private fun withCut(recording: Recording): Recording = if (about.isCut) recording + gzipCut(about.inflatedBytes) else recording

    private fun readIn(worker: Worker, resolve: (ReadLog) -> Unit, reject: (Throwable) -> Unit) {
        val text = Base64Text(element)
        worker.receive(WorkerAnswers(onProgress, resolve, reject, { readHere(resolve, reject) }) { worker.postMessage(text.next()) })
        worker.postMessage(ReadingWorker.greeting(about))
    }

    private fun readHere(resolve: (ReadLog) -> Unit, reject: (Throwable) -> Unit) {
        val text = Base64Text(element)
        val reader = RecordingReader(about.inflatedBytes, !about.isCompressed, about.lineSums, onProgress)
        fun feed() {
            val piece = text.next()
            if (piece == null) {
                reader.end()
            } else {
                // A timer between two pieces lets the page draw and react.
                reader.accept(piece).then({ window.setTimeout({ feed() }, 0) }, reject)
            }
        }
        feed()
        reader.recording.then(resolve, reject)
    }
}

/** Returns this recording with [problem], which its bytes alone do not show. */
internal operator fun Recording.plus(problem: Problem): Recording = copy(problems = problems + problem)
