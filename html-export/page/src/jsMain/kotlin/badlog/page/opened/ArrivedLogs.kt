package badlog.page.opened

import badlog.page.served.Download

/**
 * Fetches new logs from the page's server, one after the other, so that rules can run over them.
 *
 * @param onFetched called with each log once its bytes have arrived.
 */
internal class ArrivedLogs(private val onFetched: (OpenedLog) -> Unit) {
    private val waiting = LinkedHashMap<String, OpenedLog>()
    private var download: Download? = null

    /** Adds [log] to the queue, unless it is so large that only a person may request it. */
    fun add(log: OpenedLog) {
        if (log.size <= MAX_BYTES) waiting[log.path] = log
    }

    /** Removes the log at [path] from the queue because it has changed or is gone. */
    fun remove(path: String) {
        waiting.remove(path)
    }

    /**
     * Fetches the waiting logs, including logs that the server refused before. A robot's server refuses them while the robot is enabled.
     */
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
            // A refused log must not delay the logs behind it.
            if (waiting[log.path] === log) {
                waiting.remove(log.path)
                waiting[log.path] = log
            }
        })
    }

    /** Stops fetching until the next [fetch], to leave the network to the logs that a person opens. */
    fun pause() {
        val started = download ?: return
        download = null
        started.cancel()
    }
}

/** The maximum size of a log, in bytes: a robot's server sends it in about 20 s. */
private const val MAX_BYTES = 20_000_000L
