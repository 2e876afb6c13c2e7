package badlog.page.reading

import badlog.page.dom.startWorker
import badlog.rules.RuleSet
import org.w3c.dom.Worker
import org.w3c.files.File
import kotlin.js.Promise

/**
 * Reads a log from files that a person opened, in a worker if the browser allows one. The files stay on the person's computer.
 *
 * @param greeting the worker's first message.
 * @param reader returns the same log, read on the page, from a function that receives the progress.
 * @param onProgress receives the fraction that has been read, 0 to 1.
 */
internal class FileReading private constructor(
    private val greeting: () -> dynamic,
    private val reader: ((Double) -> Unit) -> Promise<ReadLog>,
    private val onProgress: (Double) -> Unit,
) {
    /** Reads the [files] of one log; only the topics in [wanted], if it is not null. */
    constructor(files: List<File>, wanted: WantedTopics? = null, onProgress: (Double) -> Unit) : this(
        { ReadingWorker.greeting(files, wanted) },
        { advance -> LogFileReader(files, wanted, advance).read().then { ReadLog(it, isDamaged = false) } },
        onProgress,
    )

    /** Reads the logs of [match] as one log, with the signals of [rules]. */
    constructor(match: MatchFiles, rules: RuleSet, onProgress: (Double) -> Unit) : this(
        { ReadingWorker.greeting(match, rules) },
        { advance -> MatchReader(match, rules.signals, advance).read() },
        onProgress,
    )

    private var worker: Worker? = null
    private var isCancelled = false

    /** Starts, and promises the log; never fulfilled after [cancel]. */
    fun start(): Promise<ReadLog> = Promise { resolve, reject ->
        val finish = { read: ReadLog -> if (!isCancelled) resolve(read) }
        val fail = { problem: Throwable -> if (!isCancelled) reject(problem) }
        var hasRead = false
        val readHere = { Promise.resolve(Unit).then { reader(::advance) }.unsafeCast<Promise<ReadLog>>().then(finish, fail) }
        val started = startWorker().also { worker = it } ?: return@Promise readHere().unsafeCast<Unit>()
        started.receive(
            WorkerAnswers(
                onProgress = {
                    hasRead = true
                    advance(it)
                },
                onRead = { finish(it) },
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
        started.postMessage(greeting())
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
