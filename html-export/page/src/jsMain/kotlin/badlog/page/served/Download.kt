package badlog.page.served

import badlog.page.dom.json
import badlog.page.dom.partsOf
import badlog.page.dom.place
import org.w3c.files.File
import org.w3c.files.FilePropertyBag
import kotlin.js.Promise

/**
 * Downloads the bytes of [files] from the page's server, one after the other.
 *
 * @param onProgress receives the fraction that has arrived, 0 to 1.
 */
internal class Download(private val files: List<File>, private val onProgress: (Double) -> Unit) {
    private val abort = js("new AbortController()")
    private val size = files.sumOf { it.served?.size ?: 0.0 }
    private var done = 0.0

    /** Starts the download. Promises each file with its bytes; rejected with a sentence for the user. */
    fun start(): Promise<Map<File, File>> {
        val fetched = LinkedHashMap<File, File>()
        return files.fold(Promise.resolve(Unit)) { before, file ->
            before.then { fetch(file) }.then { fetched[file] = it.unsafeCast<File>() }
        }.then { fetched }
    }

    /** Stops the download. */
    fun cancel() {
        abort.abort()
    }

    private fun fetch(file: File): Promise<File> = fetch(file, checkNotNull(file.served).address)

    private fun fetch(file: File, address: String): Promise<File> = ask(address, abort.signal).then { response ->
        partsOf(response) {
            done += it.length
            // A log that is being written has grown since it was listed.
            onProgress((done / size).coerceAtMost(1.0))
        }.then({ parts ->
            val bag = json("lastModified" to file.asDynamic().lastModified)
            File(parts.toTypedArray(), file.name, bag.unsafeCast<FilePropertyBag>()).also { it.place = file.place }
        }, {
            // A server that ended the download on purpose gives the reason when it is asked again.
            ask(address, abort.signal, from = 0.0).then {
                cancel()
                throw IllegalStateException(LOST)
            }
        })
    }.unsafeCast<Promise<File>>()
}
