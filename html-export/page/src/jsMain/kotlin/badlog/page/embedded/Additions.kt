package badlog.page.embedded

import badlog.protocol.PageAdditions
import badlog.protocol.fromJson
import kotlinx.browser.document

/**
 * Returns the page's content besides the recording.
 *
 * Null if this browser cannot read it, for example because it is too long for a string.
 */
internal fun findAdditions(): PageAdditions? {
    val element = document.getElementById("additions") ?: return PageAdditions()
    return try {
        PageAdditions.fromJson(element.textContent.orEmpty())
    } catch (problem: Throwable) {
        console.error(problem)
        null
    }
}
