package badlog.page.served

import badlog.page.dom.json
import kotlinx.browser.window
import org.w3c.fetch.NO_STORE
import org.w3c.fetch.RequestCache
import org.w3c.fetch.RequestInit
import org.w3c.fetch.Response
import kotlin.js.Promise

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
