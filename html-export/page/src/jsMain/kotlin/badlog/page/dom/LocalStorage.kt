package badlog.page.dom

import kotlinx.browser.localStorage

/** The browser's storage between visits. Pages on a disk may not be allowed to store anything; then nothing is stored. */
internal object LocalStorage {
    /** Returns the text stored under [key]; null if there is none. */
    operator fun get(key: String): String? = try {
        localStorage.getItem("badlog:$key")
    } catch (_: Throwable) {
        null
    }

    /** Returns the stored keys that begin with [start]. */
    fun keys(start: String): List<String> = try {
        val own = List(localStorage.length) { localStorage.key(it).orEmpty() }.filter { it.startsWith("badlog:$start") }
        own.map { it.removePrefix("badlog:") }
    } catch (_: Throwable) {
        emptyList()
    }

    /** Removes the text stored under [key]. */
    fun remove(key: String) {
        try {
            localStorage.removeItem("badlog:$key")
        } catch (_: Throwable) {
            // Nothing is stored where storing is forbidden.
        }
    }

    /** Stores [text] under [key] if storing is allowed. */
    operator fun set(key: String, text: String) {
        try {
            localStorage.setItem("badlog:$key", text)
        } catch (_: Throwable) {
            // Forbidden, or full: the page works without storage.
        }
    }
}

/** Returns a JavaScript object with [members], the form in which libraries accept options. */
internal fun json(vararg members: Pair<String, Any?>): dynamic {
    val json = js("({})")
    for ((name, value) in members) json[name] = value
    return json
}
