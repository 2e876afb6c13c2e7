package badlog.page.reading

import badlog.page.dom.json
import badlog.page.embedded.About
import badlog.rules.RuleSet
import badlog.rules.fromJson
import badlog.rules.toJson
import org.w3c.dom.DedicatedWorkerGlobalScope
import org.w3c.dom.MessageEvent
import org.w3c.files.File
import kotlin.js.Promise

/**
 * The worker that reads the recording, so that the page stays responsive. Its script is the page's own.
 *
 * The page sends an object with `expectedBytes`, `isWhole` and `lineSums`, then strings of base64, one for each `"more"` it receives, then
 * null; or it sends an object with `files` and `wanted`, or with `logs`, their
 * `names`, `manifest`, the names of `all` files, and `rules`. The worker answers with `"more"`, numbers (the fraction that is done), an object
 * with `failure`, or the recording with `isDamaged` and `made`. Its answers to parts of a recording are described in [PartMessage].
 */
internal object ReadingWorker {
    /** Whether this script runs in the worker. */
    val isHere: Boolean get() = js("typeof document === 'undefined'").unsafeCast<Boolean>()

    /** Returns the first message from the page. */
    fun greeting(about: About): dynamic {
        val message = js("({})")
        message.expectedBytes = about.inflatedBytes
        message.isWhole = !about.isCompressed
        message.lineSums = about.lineSums
        return message
    }

    /** Returns the first message for reading [files]; [wanted] names the topics to read, null for all. */
    fun greeting(files: List<File>, wanted: WantedTopics?): dynamic {
        val message = js("({})")
        message.files = files.toTypedArray()
        message.wanted = wanted?.names?.toTypedArray()
        return message
    }

    /** Returns the first message for reading [match], with the signals of [rules]. */
    fun greeting(match: MatchFiles, rules: RuleSet): dynamic = json(
        "logs" to match.logs.values.map { it.toTypedArray() }.toTypedArray(),
        "names" to match.logs.keys.toTypedArray(),
        "manifest" to match.manifest,
        "all" to match.names.toTypedArray(),
        "rules" to rules.toJson(),
    )

    /** Answers the page's messages, in the worker. */
    fun run() {
        val page = js("self").unsafeCast<DedicatedWorkerGlobalScope>()
        var reader: RecordingReader? = null
        page.onmessage = { event: MessageEvent ->
            val message: dynamic = event.data
            val current = reader
            when {
                PartMessage.isPart(message) -> PartMessage.answer(page, message)
                message != null && message.files != undefined -> readFiles(page, message)
                message != null && message.logs != undefined -> readMatch(page, message)
                current == null -> reader = open(page, message)
                message == null -> current.end()
                else -> current.accept(message as String).then({ page.postMessage(MORE) }, { answerFailure(page, it) })
            }
        }
    }

    private fun open(page: DedicatedWorkerGlobalScope, greeting: dynamic): RecordingReader {
        val lineSums = greeting.lineSums.unsafeCast<Array<Int>>()
        val reader = RecordingReader(greeting.expectedBytes as Double, greeting.isWhole as Boolean, lineSums) {
            page.postMessage(it)
        }
        reader.recording.then({ read -> answer(page, read) }).catch { answerFailure(page, it) }
        page.postMessage(MORE)
        page.postMessage(MORE)
        return reader
    }

    private fun readFiles(page: DedicatedWorkerGlobalScope, message: dynamic) {
        val wanted = message.wanted.unsafeCast<Array<String>?>()?.let { WantedTopics(it.toSet()) }
        val reader = LogFileReader(message.files.unsafeCast<Array<File>>().toList(), wanted) { page.postMessage(it) }
        reader.read().then({ read -> answer(page, ReadLog(read, isDamaged = false)) }).catch { answerFailure(page, it) }
    }

    private fun readMatch(page: DedicatedWorkerGlobalScope, message: dynamic) {
        val logs = message.logs.unsafeCast<Array<Array<File>>>().map { it.toList() }
        val names = message.all.unsafeCast<Array<String>>().toSet()
        val match = MatchFiles(message.names.unsafeCast<Array<String>>().zip(logs).toMap(), message.manifest as String?, names)
        val rules = checkNotNull(RuleSet.fromJson(message.rules as String))
        // A manifest with mistakes fails at once.
        val read = Promise.resolve(Unit).then { MatchReader(match, rules.signals) { page.postMessage(it) }.read() }
        read.unsafeCast<Promise<ReadLog>>().then({ answer(page, it) }).catch { answerFailure(page, it) }
    }

    private fun answer(page: DedicatedWorkerGlobalScope, read: ReadLog) {
        val answer = RecordingMessage.of(read.recording)
        answer.isDamaged = read.isDamaged
        answer.made = read.made
        page.postMessage(answer, RecordingMessage.buffersOf(read.recording))
    }

    private fun answerFailure(page: DedicatedWorkerGlobalScope, problem: Throwable) {
        val message = js("({})")
        message.failure = problem.message ?: problem.toString()
        page.postMessage(message)
    }

    /** The worker's message when it has room for another piece. */
    const val MORE: String = "more"
}
