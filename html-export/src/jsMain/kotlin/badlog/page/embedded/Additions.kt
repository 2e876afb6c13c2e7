package badlog.page.embedded

import badlog.html.protocol.PageAdditions
import badlog.html.protocol.fromJson
import kotlinx.browser.document

/** What the page carries besides the recording; null when this browser cannot read it, as when it is longer than a text may be. */
internal fun findAdditions(): PageAdditions? {
    val element = document.getElementById("additions") ?: return PageAdditions()
    return try {
        PageAdditions.fromJson(element.textContent.orEmpty())
    } catch (problem: Throwable) {
        console.error(problem)
        null
    }
}
