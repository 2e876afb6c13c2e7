package badlog.report.page

import badlog.core.recording.Severity
import badlog.files.terminal.printable
import badlog.rules.Finding
import badlog.viewer.session.link.FindingName
import badlog.viewer.session.link.PageAddress
import java.net.URLEncoder
import java.security.MessageDigest
import java.util.Base64

/** Returns [text] escaped for HTML: names and texts come from files. */
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

/**
 * Returns [text] as a link to [finding] on the page [page]. The link leads to the start of the page if the finding has no time. Without a
 * page, the text has no link.
 */
internal fun linked(text: String, page: String?, finding: Finding? = null): String {
    if (page == null || text.isEmpty()) return escaped(text)
    val place = finding?.takeIf { it.time.isFinite() }?.let { PageAddress(it.time, finding = FindingName.of(it)).toText() }.orEmpty()
    return "<a href=\"${escaped("./" + urlOf(page) + place)}\">${escaped(text)}</a>"
}

/** Returns [path] with everything but plain characters encoded, so that no name becomes a scheme, a query or a fragment. */
private fun urlOf(path: String): String = path.split('/').joinToString("/") { URLEncoder.encode(it, Charsets.UTF_8).replace("+", "%20") }

/** Returns the hash by which a page allows [text] as its style or script. */
internal fun hashOf(text: String): String =
    "sha256-" + Base64.getEncoder().encodeToString(MessageDigest.getInstance("SHA-256").digest(text.encodeToByteArray()))

/** The CSS class of this severity. */
internal val Severity.cssClass: String get() = name.lowercase()
