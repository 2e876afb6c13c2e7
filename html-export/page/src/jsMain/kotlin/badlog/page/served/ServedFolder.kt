package badlog.page.served

import kotlinx.browser.window
import org.w3c.files.File
import kotlin.js.Promise

/**
 * The logs of the page's own server, in the page's folder and the folders below. It sends requests as WPILib's web server expects them.
 * Answers of that server contain no modification times.
 */
internal class ServedFolder {
    private var foldersLeft = MAX_FOLDERS
    private var hasListed = false

    /** The folders that the server did not list at first. */
    private val closed = HashSet<String>()

    /**
     * Requests all logs. The promise is rejected with a sentence for the user if the server does not list the page's folder, or a folder
     * that it listed before. Otherwise the folder's logs would seem to be gone.
     */
    fun files(): Promise<List<File>> {
        foldersLeft = MAX_FOLDERS
        return list("./", NAME, MAX_DEPTH).then {
            hasListed = true
            it
        }
    }

    private fun without(place: String, problem: Throwable): List<File> {
        if (hasListed && place !in closed) throw problem
        closed += place
        return emptyList()
    }

    private fun list(folder: String, place: String, depth: Int): Promise<List<File>> =
        ask("$folder?format=json").then { it.text() }.then { text ->
            val listing = parsed(text.unsafeCast<String>())
            val files = listing.files.orEmpty().filter(::isVisible).map {
                val served = ServedFile(folder + encodeURIComponent(it.name), it.size ?: 0.0)
                fileFor(served, it.name, "$place/${it.name}", it.modified ?: 0.0)
            }
            val below = listing.dirs.orEmpty().filter { depth > 0 && isVisible(it) && foldersLeft-- > 0 }
                .map { below ->
                    val inside = "$place/${below.name}"
                    list("$folder${encodeURIComponent(below.name)}/", inside, depth - 1).catch { without(inside, it) }
                }
            Promise.all(below.toTypedArray()).then { files + it.toList().flatten() }
        }.unsafeCast<Promise<List<File>>>()

    // A hidden folder contains nothing that a robot logged.
    private fun isVisible(entry: Entry) = !entry.name.startsWith('.')

    private fun parsed(text: String): FolderListing = try {
        JSON.parse(text)
    } catch (_: Throwable) {
        throw IllegalStateException("Its server answers with a page instead of a list: this page must not be called index.html there.")
    }

    companion object {
        /** The name of the server's list. */
        val NAME: String = "Robot ${window.location.hostname}"

        /** Enough for logs of a season by event and day; stops the search in other folders. */
        private const val MAX_DEPTH = 3
        private const val MAX_FOLDERS = 100
    }
}

/** The answer of a server that lists a folder. */
private external interface FolderListing {
    val dirs: Array<Entry>?
    val files: Array<Entry>?
}

/** A folder or a file in it. */
private external interface Entry {
    val name: String

    /** The number of bytes of a file. */
    val size: Double?

    /** The time when a file was last written, in ms since 1970; null if the server does not report it. */
    val modified: Double?
}

private external fun encodeURIComponent(text: String): String
