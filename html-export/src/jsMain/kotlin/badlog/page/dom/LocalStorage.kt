package badlog.page.dom

import kotlinx.browser.localStorage

/**
 * What the browser keeps between two visits. Pages on a disk may be forbidden to keep anything: then nothing is kept.
 */
internal object LocalStorage {
    /** What was kept under [key], or null. */
    operator fun get(key: String): String? = try {
        localStorage.getItem("badlog:$key")
    } catch (_: Throwable) {
        null
    }

    /** Keeps [text] under [key], if it may. */
    operator fun set(key: String, text: String) {
        try {
            localStorage.setItem("badlog:$key", text)
        } catch (_: Throwable) {
            // Forbidden, or full: a page that forgets is still a page.
        }
    }
}
