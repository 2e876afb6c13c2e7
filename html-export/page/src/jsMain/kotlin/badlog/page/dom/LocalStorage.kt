package badlog.page.dom

import kotlinx.browser.localStorage

/**
 * What the browser stores between visits. Pages on a disk may not be allowed to store anything: then nothing is
 * stored.
 */
internal object LocalStorage {
    /** Returns what was stored under [key], or null. */
    operator fun get(key: String): String? = try {
        localStorage.getItem("badlog:$key")
    } catch (_: Throwable) {
        null
    }

    /** Stores [text] under [key], if that is allowed. */
    operator fun set(key: String, text: String) {
        try {
            localStorage.setItem("badlog:$key", text)
        } catch (_: Throwable) {
            // Forbidden, or full: the page works without storage.
        }
    }
}
