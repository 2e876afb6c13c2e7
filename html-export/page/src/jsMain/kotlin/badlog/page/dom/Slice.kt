package badlog.page.dom

import kotlinx.browser.document

/** Returns the milliseconds that work may take before the page must respond: [seen], or more if the page is hidden. */
internal fun sliceMillis(seen: Int): Int = if (document.asDynamic().hidden == true) HIDDEN else seen

/** A browser wakes a hidden page only once a second. */
private const val HIDDEN = 800
