package badlog.page.reading

import badlog.bag.BagParser
import badlog.page.embedded.About
import badlog.page.embedded.Base64Text
import badlog.recording.NumberSinks
import badlog.recording.Recording
import kotlinx.browser.window
import org.w3c.dom.Element
import org.w3c.dom.MessageEvent
import org.w3c.dom.Worker
import kotlin.js.Promise

/**
 * Reads a recording in the parts that its exporter deflated apart from each other: several workers inflate them and read their
 * rows, the page puts these together in their order.
 */
internal class PartsReading private constructor(
    private val about: About,
    element: Element,
    private val workers: List<Worker>,
    private val onProgress: (Double) -> Unit,
) {
    private val text = Base64Text(element)
    private val parser = BagParser(about.inflatedBytes.toLong(), keepSamples = true, NumberSinks.RECORDING, about.lines.toLong())
    private val answers = HashMap<Int, dynamic>()
    private val count = about.parts.size - 1

    /** Those with room for one more part, once for each. */
    private val ready = ArrayDeque<Worker>()
    private var held = ""
    private var sent = 0
    private var taken = 0
    private var takenBytes = 0.0
    private lateinit var resolve: (Recording) -> Unit
    private lateinit var reject: (Throwable) -> Unit

    private fun start(): Promise<Recording> = Promise { resolve, reject ->
        this.resolve = resolve
        this.reject = reject
        for (worker in workers) {
            worker.onerror = { fail("A worker cannot run.") }
            worker.onmessage = { event: MessageEvent ->
                try {
                    answered(worker, event.data)
                } catch (problem: Throwable) {
                    fail(problem.message ?: problem.toString())
                }
            }
        }
        // The header is in the first part, and nobody can read rows without it.
        send(workers[0])
    }

    private fun send(worker: Worker) {
        if (sent == count) return
        val from = about.parts[sent]
        val until = about.parts[sent + 1]
        // A group of three bytes may belong to two parts.
        val start = if (sent == 0) 0.0 else from - from % GROUP_BYTES
        val begun = if (sent == 0 || from % GROUP_BYTES == 0.0) "" else held
        val characters = groupsUntil(until) - (if (sent == 0) 0.0 else groupsUntil(from))
        val base64 = begun + text.next((characters * GROUP_CHARACTERS).toInt()).orEmpty()
        held = base64.takeLast(GROUP_CHARACTERS)
        val last = sent == count - 1
        val columns = if (sent == 0) null else parser.readsDecimalComma
        worker.postMessage(PartMessage.of(sent, base64, (from - start).toInt(), (until - start).toInt(), last, columns))
        sent++
    }

    private fun groupsUntil(bytes: Double) = kotlin.math.ceil(bytes / GROUP_BYTES)

    private fun answered(worker: Worker, message: dynamic) {
        if (message.failure != undefined) return fail(message.failure as String)
        answers[message.part as Int] = message
        while (true) {
            takenBytes += PartMessage.take(answers.remove(taken) ?: break, parser)
            taken++
        }
        onProgress(takenBytes / about.inflatedBytes)
        if (taken == count) return finish()
        if (taken > 0 && parser.readsDecimalComma == null) return fail("No rows begin in the first part.")
        if (message.part == 0) repeat(AHEAD) { ready += workers } else ready += worker
        // What fast workers read waits for the slowest, and takes memory.
        while (ready.isNotEmpty() && sent - taken < workers.size * MAX_AHEAD) send(ready.removeFirst())
    }

    private fun finish() {
        if (takenBytes != about.inflatedBytes) return fail("Parts are missing.")
        workers.forEach { it.terminate() }
        window.performance.asDynamic().mark("badlog-parts-read")
        resolve(parser.finish())
    }

    private fun fail(reason: String) {
        workers.forEach { it.terminate() }
        reject(Error(reason))
    }

    companion object {
        private const val GROUP_BYTES = 3
        private const val GROUP_CHARACTERS = 4

        /** So many parts are on their way to each worker. */
        private const val AHEAD = 2

        /** So many parts for each worker are on their way, or wait for those before them. */
        private const val MAX_AHEAD = 4
        private const val MAX_WORKERS = 4

        /** Starts, and promises the recording; null where it has no parts, or the browser cannot read them at a time. */
        fun start(about: About, element: Element, onProgress: (Double) -> Unit): Promise<Recording>? {
            val cores = minOf(window.navigator.hardwareConcurrency.toInt(), MAX_WORKERS, about.parts.size - 1)
            if (cores < 2 || !canInflateParts()) return null
            val workers = List(cores) { ReadingWorker.start() ?: return null }
            return PartsReading(about, element, workers, onProgress).start()
        }

        private fun canInflateParts(): Boolean = try {
            js("new DecompressionStream('deflate-raw')") != null
        } catch (_: Throwable) {
            false
        }
    }
}
