package badlog.page.opened

import badlog.page.served.Download

/**
 * Fetches logs that have arrived on the page's server, one after the other, so that rules can run over them.
 *
 * @param onFetched called with each, whose bytes are here now.
 */
internal class ArrivedLogs(private val onFetched: (OpenedLog) -> Unit) {
    private val waiting = LinkedHashMap<String, OpenedLog>()
    private var download: Download? = null

    /** Fetches [log], too, unless it is so large that a person has to ask for it. */
    fun add(log: OpenedLog) {
        if (log.size <= MAX_BYTES) waiting[log.path] = log
    }

    /** No longer waits for the log at [path], which has changed since or is gone. */
    fun remove(path: String) {
        waiting.remove(path)
    }

    /** Fetches those that wait; again those that the server refused, as a robot that is enabled does. */
    fun fetch() {
        val log = waiting.values.firstOrNull() ?: return
        if (download != null) return
        val started = Download(log.files) {}
        download = started
        started.start().then({ fetched ->
            if (download !== started) return@then
            download = null
            if (waiting[log.path] === log) {
                waiting.remove(log.path)
                onFetched(log.with(fetched))
            }
            fetch()
        }, {
            if (download !== started) return@then
            download = null
            // It must not keep those behind it from coming.
            if (waiting[log.path] === log) {
                waiting.remove(log.path)
                waiting[log.path] = log
            }
        })
    }

    /** Leaves the network to what a person opens, until the next [fetch]. */
    fun pause() {
        val started = download ?: return
        download = null
        started.cancel()
    }

    /** Ends it. */
    fun stop() {
        waiting.clear()
        pause()
    }

    private companion object {
        /** What a robot's server sends in some 20 s. */
        const val MAX_BYTES = 20_000_000L
    }
}
