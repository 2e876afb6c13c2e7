package badlog.page.dom

import kotlinx.browser.document

/** Returns for how many milliseconds work may go on before the page must respond: [seen], unless nobody sees the page. */
internal fun sliceMillis(seen: Int): Int = if (document.asDynamic().hidden == true) HIDDEN else seen

/** A browser wakes a page that nobody sees only once a second. */
private const val HIDDEN = 800
