package badlog.page.served

import badlog.formats.TEXT_ENDINGS
import badlog.page.dom.json
import badlog.page.dom.place
import kotlinx.browser.window
import org.khronos.webgl.ArrayBuffer
import org.khronos.webgl.Uint8Array
import org.khronos.webgl.get
import org.w3c.fetch.NO_STORE
import org.w3c.fetch.RequestCache
import org.w3c.fetch.RequestInit
import org.w3c.fetch.Response
import org.w3c.files.Blob
import org.w3c.files.File
import org.w3c.files.FilePropertyBag
import kotlin.js.Promise

/**
 * A log at [address] that the page's server is still writing. Requests its new bytes, or all of it if the server does not support parts.
 *
 * @param file the content of the log so far.
 */
internal class GrowingFile(private val file: File, private val address: String) {
    private var bytes: Blob = file

    /** The end of the last whole row, because a part may not contain the end of a row. */
    private var whole = file.size.toInt()

    // In files that are not text, any byte may equal a line feed.
    private val isText = TEXT_ENDINGS.any { file.name.endsWith(it, ignoreCase = true) }

    /** The milliseconds to wait before the next [more]; whole logs are requested less often. */
    var pause = PAUSE
        private set

    /**
     * Returns the log with its new bytes, up to its last whole row; null if there are none. The promise is rejected with a sentence for the
     * user.
     */
    fun more(): Promise<File?> = ask(address, from = bytes.size.toDouble() - KNOWN_BYTES).then { response ->
        response.arrayBuffer().catch<ArrayBuffer> { throw RetryLaterException(LOST) }.then { take(it, response.status == PART) }
    }.unsafeCast<Promise<File?>>()

    private fun take(buffer: ArrayBuffer, isPart: Boolean): File? {
        pause = if (isPart) PAUSE else maxOf(PAUSE, buffer.byteLength / WHOLE_BYTES_PER_MILLI)
        val begin = if (isPart) bytes.size.toInt() - KNOWN_BYTES else 0
        if (begin + buffer.byteLength <= bytes.size.toInt()) return null
        bytes = Blob(if (isPart) arrayOf(bytes, buffer.slice(KNOWN_BYTES)) else arrayOf(buffer))
        val end = if (isText) endOfLines(Uint8Array(buffer), begin) else bytes.size.toInt()
        if (end <= whole) return null
        whole = end
        val options = json("lastModified" to file.asDynamic().lastModified).unsafeCast<FilePropertyBag>()
        return File(arrayOf(bytes.slice(0, end)), file.name, options).also { it.place = file.place }
    }

    /** Returns the end of the last whole line in [part], which starts at [begin]; an incomplete row may follow. */
    private fun endOfLines(part: Uint8Array, begin: Int): Int {
        var end = part.length
        while (end > 0 && part[end - 1] != LINE_FEED) end--
        return if (end > 0) begin + end else whole
    }
}

/**
 * The place of a listed log on a server.
 *
 * @property address the address of the log.
 * @property size the size of the log when it was listed, in bytes.
 */
internal class ServedFile(val address: String, val size: Double)

/** The place of this file on a server; null for a file that is here. */
internal val File.served: ServedFile? get() = asDynamic().served.unsafeCast<ServedFile?>()

/**
 * Returns an empty file that represents [served] in lists. It is named [name] at [place], and was last written at [modified], in ms since
 * 1970.
 */
internal fun fileFor(served: ServedFile, name: String, place: String, modified: Double): File =
    File(emptyArray(), name, json("lastModified" to modified).unsafeCast<FilePropertyBag>()).also {
        it.place = place
        it.asDynamic().served = served
    }

/**
 * Requests [address], relative to the page, from the page's own server. The promise of the response is rejected with a sentence for the
 * user if the server refuses or does not answer.
 *
 * @param signal aborts the request.
 * @param from the first byte to request, if the server supports that; null for all.
 */
internal fun ask(address: String, signal: dynamic = undefined, from: Double? = null): Promise<Response> {
    val options = json("signal" to signal).unsafeCast<RequestInit>()
    if (from != null) {
        options.headers = json("Range" to "bytes=$from-")
        options.cache = RequestCache.NO_STORE
    }
    return window.fetch(address, options).catch<Response> { throw RetryLaterException(LOST) }.then { response ->
        if (response.ok) Promise.resolve(response) else response.text().then { refuse(it, response) }
    }.unsafeCast<Promise<Response>>()
}

private fun refuse(text: String, response: Response): Response {
    // A robot's server answers with the reason in one sentence; other servers answer with a page.
    val isSentence = text.length < MAX_SENTENCE && '<' !in text
    val sentence = if (isSentence) text.trim() else "The server answered ${response.status}."
    throw if (response.headers.has("Retry-After")) RetryLaterException(sentence) else IllegalStateException(sentence)
}

/** Thrown if there is no answer now, but there may be one in a few seconds. */
internal class RetryLaterException(sentence: String) : IllegalStateException(sentence)

/** The reason why a download ended. */
internal const val LOST = "The robot does not answer: stay on its Wi-Fi, and try again."

private const val MAX_SENTENCE = 200

private const val PAUSE = 50

/** The number of known bytes to request again, because a request for only missing bytes is an error. */
private const val KNOWN_BYTES = 1

/** The rate of whole logs, 2 Mbit/s: half of the bandwidth of a robot on a field. */
private const val WHOLE_BYTES_PER_MILLI = 250
private const val LINE_FEED: Byte = 10
private const val PART: Short = 206
