package badlog.page.reading

import badlog.core.recording.Recording
import badlog.page.dom.startWorker
import org.w3c.dom.Worker
import org.w3c.files.File
import kotlin.js.Promise

/**
 * Reads a log from [files] that a person opened, in a worker if the browser allows one. The files stay on the person's computer.
 *
 * @param wanted the only topics to keep; null for all.
 * @param onProgress receives the fraction of the bytes that has been read, 0 to 1.
 */
internal class FileReading(
    private val files: List<File>,
    private val wanted: WantedTopics? = null,
    private val onProgress: (Double) -> Unit,
) {
    private var worker: Worker? = null
    private var isCancelled = false

    /** Starts, and promises the recording; never fulfilled after [cancel]. */
    fun start(): Promise<Recording> = Promise { resolve, reject ->
        val finish = { read: Recording -> if (!isCancelled) resolve(read) }
        val fail = { problem: Throwable -> if (!isCancelled) reject(problem) }
        var hasRead = false
        val readHere = { LogFileReader(files, wanted, ::advance).read().then(finish, fail) }
        val started = startWorker().also { worker = it } ?: return@Promise readHere().unsafeCast<Unit>()
        started.receive(
            WorkerAnswers(
                onProgress = {
                    hasRead = true
                    advance(it)
                },
                onRead = { finish(it.recording) },
                // On pages from a disk, WebKit's workers cannot read files.
                onFailure = {
                    if (hasRead) {
                        fail(it)
                    } else if (!isCancelled) {
                        readHere()
                    }
                },
                onRefusal = { readHere() },
            ),
        )
        started.postMessage(ReadingWorker.greeting(files, wanted))
    }

    /** Stops reading. */
    fun cancel() {
        isCancelled = true
        worker?.terminate()
    }

    private fun advance(share: Double) {
        if (!isCancelled) onProgress(share)
    }
}
