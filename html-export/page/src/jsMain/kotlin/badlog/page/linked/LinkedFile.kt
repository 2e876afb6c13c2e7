package badlog.page.linked

import badlog.page.dom.PageEvents
import badlog.page.dom.json
import badlog.page.dom.partsOf
import kotlinx.browser.window
import org.khronos.webgl.ArrayBuffer
import org.w3c.dom.MessageEvent
import org.w3c.dom.url.URL
import org.w3c.fetch.RequestInit
import org.w3c.fetch.Response
import org.w3c.files.Blob
import org.w3c.files.File
import kotlin.js.Promise

/**
 * A file on the web named by a link to this page, as in `#url=https://example.org/match.bag`. Its host, and any host it redirects to,
 * receives the request without cookies and without a referrer.
 */
internal class LinkedFile private constructor(private val address: URL) {
    private val abort = js("new AbortController()")

    /** The host that receives the request. */
    val host: String get() = address.host

    /** The name of the file. */
    val name: String = fileNameOf(decoded(address.pathname.substringAfterLast('/')))

    /**
     * Downloads the file. [onProgress] receives the fraction that has arrived, 0 to 1, if the size is known. If the download fails, the
     * promise rejects with a sentence for the user.
     */
    fun fetch(onProgress: (Double) -> Unit): Promise<File> {
        val options = json("credentials" to "omit", "referrerPolicy" to "no-referrer", "signal" to abort.signal).unsafeCast<RequestInit>()
        return window.fetch(address.href, options).catch<Response> { fail(NOT_SENT) }.then { response ->
            val size = response.headers.get("Content-Length")?.toDoubleOrNull() ?: 0.0
            when {
                response.status.toInt() == NOT_FOUND -> fail("$host has no such file. Ask whoever sent the link.")

                !response.ok -> fail("$host refuses to send it (${response.status}).")

                size > MAX_BYTES -> {
                    cancel()
                    fail(TOO_LARGE)
                }

                else -> received(response, size, onProgress)
            }
        }.unsafeCast<Promise<File>>()
    }

    /** Stops the download. */
    fun cancel() {
        abort.abort()
    }

    private fun received(response: Response, size: Double, onProgress: (Double) -> Unit): Promise<File> {
        var done = 0.0
        return partsOf(response) {
            done += it.length
            if (done > MAX_BYTES) cancel()
            if (size > 0) onProgress((done / size).coerceAtMost(1.0))
        }.then({ File(it.toTypedArray(), name) }, { fail(if (done > MAX_BYTES) TOO_LARGE else NOT_SENT) })
    }

    private fun fail(sentence: String): Nothing = throw IllegalStateException(sentence)

    private val NOT_SENT get() =
        "$host does not answer, or does not let other sites read its files (CORS). Download the file there, and open it here."

    companion object {
        private const val NOT_FOUND = 404
        private const val MAX_BYTES = 500e6
        private const val TOO_LARGE = "It is larger than 500 MB. Download it, and open it here."
        private const val KEY = "url="

        /** Returns the file named in the page's own address; null if there is none, or if the page may not request it. */
        fun inAddress(): LinkedFile? {
            val named = window.location.hash.removePrefix("#").split('&').firstOrNull { it.startsWith(KEY) } ?: return null
            return try {
                val address = URL(decoded(named.removePrefix(KEY)))
                // The page's policy forbids all others.
                if (address.protocol == "https:" || address.origin == window.location.origin) LinkedFile(address) else null
            } catch (_: Throwable) {
                null
            }
        }

        private fun decoded(text: String): String = try {
            decodeURIComponent(text)
        } catch (_: Throwable) {
            text
        }
    }
}

private external fun decodeURIComponent(text: String): String

/**
 * A log that another program, which opened this page, passes to it by Perfetto's protocol. The program sends `PING` until it receives
 * `PONG`, then an object `{badlog: {buffer, fileName}}`. Nothing else is ever sent back, and nothing is read before a person has agreed.
 *
 * @property origin the origin of the program, as reported by the browser.
 */
internal class HandedFile private constructor(val origin: String, private val bytes: Any, val name: String) {
    /** Returns the log as a file. */
    fun file(): File = File(arrayOf(bytes), name)

    companion object {
        /** Calls [onHanded] with each log that arrives this way, until something else is shown. */
        fun await(onHanded: (HandedFile) -> Unit) = PageEvents.on(window, "message") { event ->
            val message = event.unsafeCast<MessageEvent>()
            val sender: dynamic = message.source
            val handed: dynamic = message.data
            when {
                sender == null || sender == window -> Unit

                // An array with the text equals the text, too.
                jsTypeOf(handed) == "string" && handed == "PING" -> sender.postMessage("PONG", addressOf(message.origin))

                else -> read(message.origin, handed?.badlog)?.let(onHanded)
            }
        }

        /**
         * Returns the target for an answer. A program without an origin, such as a file, can only be addressed as `*`; it learns only that
         * this is a page.
         */
        private fun addressOf(origin: String) = if (origin == "null") "*" else origin

        private fun read(origin: String, handed: dynamic): HandedFile? {
            if (handed == null) return null
            val bytes: Any = handed.buffer.unsafeCast<Any?>() ?: return null
            if (bytes !is ArrayBuffer && bytes !is Blob) return null
            val name = handed.fileName
            return HandedFile(origin, bytes, fileNameOf(if (jsTypeOf(name) == "string") name as String else ""))
        }
    }
}

/**
 * Returns the file name [name], given by a link or another site, without characters that could disguise it in a prompt. At most 100
 * characters; `log` if none are left.
 */
internal fun fileNameOf(name: String): String = name.filter { it >= ' ' && it !in "“”\u007F" && it !in INVISIBLE && it !in DIRECTIONS }
    .take(MAX_NAME).ifEmpty { "log" }

private const val MAX_NAME = 100

/** Characters without a width, and characters that change the direction of writing. */
private val INVISIBLE = '\u200B'..'\u202E'
private val DIRECTIONS = '\u2060'..'\u2069'
