package badlog.page.reading

import badlog.core.bag.BagParser
import badlog.core.recording.Problem
import badlog.core.recording.Recording
import badlog.page.dom.startWorker
import badlog.page.embedded.About
import badlog.page.embedded.Base64
import badlog.page.embedded.Base64Text
import badlog.page.embedded.LineSums
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element
import org.w3c.dom.MessageEvent
import org.w3c.dom.Worker
import kotlin.js.Promise

/**
 * Reads a recording in parts, as they arrive while the page loads. Its exporter deflated the parts independently, one line of base64 each.
 * Several workers inflate the parts and read their rows, and the page joins the rows in order.
 */
internal class PartsReading private constructor(
    private val expectedBytes: Double,
    element: Element,
    private val workers: List<Worker>,
    private val onProgress: (Double) -> Unit,
) {
    private val text = Base64Text(element)
    private val parser = BagParser(expectedBytes.toLong())
    private val answers = HashMap<Int, dynamic>()
    private val sums = LineSums()

    /** The workers that can accept another part, once for each such part. */
    private val ready = ArrayList<Worker>()
    private var line = ""
    private var sent = BEFORE_PARTS
    private var taken = 0
    private var takenBytes = 0.0
    private var isAllSent = false
    private var isWaiting = false
    private lateinit var resolve: (Recording) -> Unit
    private lateinit var reject: (Throwable) -> Unit

    private fun start(): Promise<Recording> = Promise { resolve, reject ->
        this.resolve = resolve
        this.reject = reject
        for (worker in workers) {
            worker.onerror = { fail("A worker cannot run.") }
            worker.onmessage = { event: MessageEvent -> guarded { answered(worker, event.data) } }
        }
        // The header is in the first part, and rows cannot be read without it.
        ready += workers[0]
        send()
    }

    private fun guarded(work: () -> Unit) = try {
        work()
    } catch (problem: Throwable) {
        fail(problem.message ?: problem.toString())
    }

    private fun send() {
        // The results of fast workers wait for the slowest worker, and take memory.
        while (ready.isNotEmpty() && sent - taken < workers.size * MAX_AHEAD) {
            // Read first, so that text that arrives later is looked at again.
            val isLoaded = document.asDynamic().readyState != "loading"
            val part = nextLine()
            if (part == null) {
                isAllSent = isLoaded
                if (!isLoaded && !isWaiting) {
                    isWaiting = true
                    window.setTimeout({
                        isWaiting = false
                        guarded(::send)
                    }, PAUSE)
                }
                break
            }
            if (sent >= 0) {
                ready.removeLast().postMessage(PartMessage.of(sent, part, if (sent == 0) null else parser.readsDecimalComma))
            } else {
                sums.add(Base64.decode(part), isLast = true)
            }
            sent++
        }
        if (isAllSent && taken == sent) finish()
    }

    /** Returns the next line that has arrived completely. */
    private fun nextLine(): String? {
        while (true) {
            line += text.next() ?: return null
            if (line.endsWith('\n')) return line.also { line = "" }
        }
    }

    private fun answered(worker: Worker, message: dynamic) {
        if (message.failure != undefined) return fail(message.failure as String)
        answers[message.part as Int] = message
        while (true) {
            val answer = answers.remove(taken) ?: break
            sums.add(answer.crc as Int)
            takenBytes += PartMessage.take(answer, parser)
            taken++
        }
        onProgress(takenBytes / expectedBytes)
        if (taken > 0 && parser.readsDecimalComma == null) return fail("No rows begin in the first part.")
        if (message.part == 0) repeat(AHEAD) { ready += workers } else ready += worker
        send()
    }

    private fun finish() {
        val about = About.find()
        // The rest is the end of the gzip stream.
        sums.add(Base64.decode(line), isLast = true)
        if (takenBytes != about?.inflatedBytes || !sums.fit(about.lineSums)) return fail("Parts are missing or damaged.")
        workers.forEach { it.terminate() }
        window.performance.asDynamic().mark("badlog-parts-read")
        resolve(parser.finish())
    }

    private fun fail(reason: String) {
        workers.forEach { it.terminate() }
        ready.clear()
        reject(Error(reason))
    }

    companion object {
        /** The first line is the header of the gzip stream. */
        private const val BEFORE_PARTS = -1

        /** The milliseconds between two checks for newly arrived text. */
        private const val PAUSE = 5

        /** The number of parts that are sent ahead to each worker. */
        private const val AHEAD = 2

        /** The maximum number of parts per worker that are in progress or wait for earlier parts. */
        private const val MAX_AHEAD = 4
        private const val MAX_WORKERS = 4

        /** Starts, and promises the recording. Returns null if it has no parts, or the browser cannot read them in parallel. */
        fun start(element: Element, onProgress: (Double) -> Unit): Promise<Recording>? {
            val bytes = element.getAttribute("data-bytes")?.toDoubleOrNull() ?: return null
            val cores = minOf(window.navigator.hardwareConcurrency.toInt(), MAX_WORKERS)
            if (cores < 2 || !canInflateParts()) return null
            val workers = List(cores) { startWorker() ?: return null }
            return PartsReading(bytes, element, workers, onProgress).start()
        }

        private fun canInflateParts(): Boolean = try {
            js("new DecompressionStream('deflate-raw')") != null
        } catch (_: Throwable) {
            false
        }
    }
}

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
