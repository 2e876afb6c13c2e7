package badlog.page.opened

import badlog.page.dom.place
import badlog.signals.match.files.MatchManifest
import kotlinx.browser.window
import org.w3c.files.File
import kotlin.js.Promise

/** A folder that a person chose. The page may look into it again, because logs in it appear and grow. */
internal class WatchedFolder(private val handle: dynamic) {
    val name: String get() = handle.name as String

    /** This folder, to be polled for changes. */
    val again: FolderPolling get() = FolderPolling(PAUSE, ::files)

    /** The number of pages in it at the last look. */
    var pages = 0
        private set

    /** The `match.json` in the folder itself; null if there was none at the last look. */
    var manifest: File? = null
        private set
    private var hasListed = false

    /** The paths that could not be read at first. */
    private val closed = HashSet<String>()

    /**
     * Promises the current files named like logs, in the folder and its folders. Entries that could never be read are skipped.
     *
     * The promise is rejected if the folder, or an entry that could be read at first, cannot be read. Otherwise its logs would seem to be
     * gone.
     */
    fun files(): Promise<List<File>> {
        pages = 0
        manifest = null
        return filesIn(handle, name).then {
            hasListed = true
            it
        }
    }

    private fun filesIn(folder: dynamic, path: String): Promise<List<File>> = Promise { resolve, reject ->
        val entries = folder.values()
        val found = ArrayList<File>()
        fun next() {
            entries.next().then({ step: dynamic ->
                if (step.done as Boolean) {
                    resolve(found)
                } else {
                    val place = "$path/${step.value.name}"
                    filesOf(step.value, place).then({ more ->
                        found += more
                        next()
                    }, { problem ->
                        if (hasListed && place !in closed) return@then reject(problem)
                        closed += place
                        next()
                    })
                }
            }, { problem: dynamic -> reject(problem.unsafeCast<Throwable>()) })
        }
        next()
    }

    private fun filesOf(entry: dynamic, place: String): Promise<List<File>> = when {
        entry.kind == "directory" -> filesIn(entry, place)

        !OpenedLog.isNamedLikeLog(place) -> {
            if (isPage(place)) pages++
            if (place != "$name/${MatchManifest.NAME}") {
                Promise.resolve(emptyList())
            } else {
                entry.getFile().then { file: File ->
                    manifest = file.apply { this.place = place }
                    emptyList<File>()
                }.unsafeCast<Promise<List<File>>>()
            }
        }

        else -> entry.getFile().then { file: File ->
            file.place = place
            listOf(file)
        }.unsafeCast<Promise<List<File>>>()
    }

    companion object {
        /** The milliseconds between two looks. */
        private const val PAUSE = 3000

        /** Whether this browser supports such folders. */
        val areThere: Boolean get() = window.asDynamic().showDirectoryPicker != undefined

        /** Promises the file of [handle] or, if it is a folder, the files in it that are named like logs. */
        fun filesOf(handle: dynamic): Promise<List<File>> =
            if (handle.kind == "directory") WatchedFolder(handle).files() else handle.getFile().then { file: File -> listOf(file) }

        /** Lets a person choose a folder. Rejected if the person cancels, or the browser forbids it. */
        fun choose(): Promise<WatchedFolder> =
            window.asDynamic().showDirectoryPicker(js("({id: 'logs'})")).then { handle: dynamic -> WatchedFolder(handle) }
                .unsafeCast<Promise<WatchedFolder>>()
    }
}
