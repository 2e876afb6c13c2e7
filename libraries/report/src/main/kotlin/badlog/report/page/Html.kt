package badlog.report.page

import badlog.recording.Severity
import badlog.terminal.printable
import java.net.URLEncoder
import java.security.MessageDigest
import java.util.Base64

/** [text] as HTML: names and texts come from files. */
internal fun escaped(text: String): String = buildString(text.length) {
    for (char in text.split('\n').joinToString("\n", transform = ::printable)) {
        when (char) {
            '&' -> append("&amp;")
            '<' -> append("&lt;")
            '>' -> append("&gt;")
            '"' -> append("&quot;")
            '\'' -> append("&#39;")
            else -> append(char)
        }
    }
}

/** [text] as a link to [fragment] of the page [page], or without one where that is null. */
internal fun linked(text: String, page: String?, fragment: String): String =
    if (page == null || text.isEmpty()) escaped(text) else "<a href=\"${escaped("./" + urlOf(page))}$fragment\">${escaped(text)}</a>"

/** `#t=` and the time, or nothing for what has none. */
internal fun fragmentOf(time: Double): String =
    if (time.isFinite()) "#t=" + time.toBigDecimal().stripTrailingZeros().toPlainString() else ""

/** [path] with everything but plain characters encoded, so that no name becomes a scheme, a query or a fragment. */
private fun urlOf(path: String): String = path.split('/').joinToString("/") { URLEncoder.encode(it, Charsets.UTF_8).replace("+", "%20") }

/** The hash by which a page allows [text] as its style or script. */
internal fun hashOf(text: String): String =
    "sha256-" + Base64.getEncoder().encodeToString(MessageDigest.getInstance("SHA-256").digest(text.encodeToByteArray()))

/** The class of what is of this severity. */
internal val Severity.cssClass: String get() = name.lowercase()
