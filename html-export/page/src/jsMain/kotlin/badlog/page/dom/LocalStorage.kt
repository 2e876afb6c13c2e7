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

    /** Returns the keys that begin with [start] and under which something is stored. */
    fun keys(start: String): List<String> = try {
        val own = List(localStorage.length) { localStorage.key(it).orEmpty() }.filter { it.startsWith("badlog:$start") }
        own.map { it.removePrefix("badlog:") }
    } catch (_: Throwable) {
        emptyList()
    }

    /** Removes what is stored under [key]. */
    fun remove(key: String) {
        try {
            localStorage.removeItem("badlog:$key")
        } catch (_: Throwable) {
            // Nothing is stored where that is forbidden.
        }
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
