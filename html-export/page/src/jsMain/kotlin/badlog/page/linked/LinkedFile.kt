package badlog.page.linked

import badlog.page.dom.json
import badlog.page.dom.partsOf
import kotlinx.browser.window
import org.w3c.dom.url.URL
import org.w3c.fetch.RequestInit
import org.w3c.fetch.Response
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
