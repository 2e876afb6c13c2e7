package badlog.page.opened

import badlog.page.dom.json
import badlog.protocol.Crc32
import kotlinx.browser.document
import kotlinx.browser.window
import kotlin.js.Promise

/**
 * The results of reading logs, stored by the browser, so that a folder need not be read again. For each path it stores the last result,
 * valid for a file of the same size and time, the same [rules], and the same program. Where a browser stores nothing, logs are read each
 * time.
 */
internal class SummaryCache(rules: String) {
    // The end of the packed program contains its checksum.
    private val version = Crc32().apply {
        update((rules + document.getElementById("packed")?.textContent?.takeLast(END)).encodeToByteArray())
    }.value
    private val database: Promise<Any> = Promise { resolve, reject ->
        val request: dynamic = window.asDynamic().indexedDB.open("badlog", 1)
        request.onupgradeneeded = { request.result.createObjectStore(STORE) }
        request.onsuccess = { resolve(request.result.unsafeCast<Any>()) }
        request.onerror = { reject(Throwable()) }
        request.onblocked = request.onerror
    }

    /** Passes the stored results of known [logs] to [onKnown], each as a worker's message; then calls [onEnd]. */
    fun find(logs: List<OpenedLog>, onKnown: (OpenedLog, message: dynamic) -> Unit, onEnd: () -> Unit) {
        var isOver = false
        fun end() {
            if (!isOver) onEnd()
            isOver = true
        }
        // Some browsers never answer if they may not store anything.
        window.setTimeout({ end() }, PATIENCE)
        database.then { opened ->
            val kept: dynamic = opened.asDynamic().transaction(STORE).objectStore(STORE)
            for (log in logs) {
                val request: dynamic = kept.get(log.path)
                request.onsuccess = {
                    val found = request.result
                    if (found != undefined && found.of == of(log) && !isOver) onKnown(log, found.message)
                }
            }
            kept.transaction.oncomplete = ::end
            kept.transaction.onabort = ::end
        }.catch { end() }
    }

    /** Stores [message], a worker's result for [log]. */
    fun keep(log: OpenedLog, message: dynamic) {
        database.then<Unit> { opened ->
            opened.asDynamic().transaction(STORE, "readwrite").objectStore(STORE).put(json("of" to of(log), "message" to message), log.path)
        }.catch {}
    }

    private fun of(log: OpenedLog) = "${log.size} ${log.modified} $version"
}

private const val STORE = "logs"
private const val END = 16

/** The milliseconds to wait for stored results; after that, logs are read instead. */
private const val PATIENCE = 1000
