package badlog.page.opened

import badlog.page.dom.place
import badlog.page.screen.isPageBusy
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

/**
 * Checks a folder for changes regularly.
 *
 * @param known the logs at the last look, by path.
 * @param onLook called after each look.
 */
internal class FolderWatch(
    private val folder: FolderPolling,
    private val known: Map<String, OpenedLog>,
    private val onLook: (FolderChanges) -> Unit,
) {
    private val changing = HashSet<String>()

    /** The paths of the logs that had changed at the last look. */
    val growing: Set<String> get() = changing
    private var timer = 0

    /** The number of calls of [stop], which invalidate looks begun before. */
    private var turn = 0

    /** Starts watching, unless it has been started. */
    fun start() {
        if (timer == 0) lookIn(folder.pause, turn)
    }

    private fun lookIn(pause: Int, begun: Int) {
        timer = window.setTimeout({
            // A log for which a person waits comes first.
            if (isPageBusy) return@setTimeout lookIn(BUSY_PAUSE, begun)
            // A folder that cannot be listed now is tried again later.
            folder.files().then({ if (begun == turn) onLook(compare(OpenedLog.logsIn(it))) }, {})
                .catch { console.error(it) }
                .then { if (begun == turn) lookIn(folder.pause, begun) }
        }, pause)
    }

    /** Stops watching, until the next [start]. */
    fun stop() {
        turn++
        window.clearTimeout(timer)
        timer = 0
    }

    private fun compare(logs: List<OpenedLog>): FolderChanges {
        val changed = logs.filter { log -> known[log.path].let { it == null || it.size != log.size || it.modified != log.modified } }
        val gone = known.keys - logs.mapTo(HashSet()) { it.path }
        // A browser does not read a file that changes meanwhile, so a log is read once it has stopped growing.
        val complete = growing - changed.mapTo(HashSet()) { it.path } - gone
        changing.clear()
        changed.mapTo(changing) { it.path }
        return FolderChanges(changed, gone, complete)
    }
}

/**
 * A folder into which the page can look again.
 *
 * @property pause the milliseconds between two looks.
 * @property files promises the current files of the folder.
 */
internal class FolderPolling(val pause: Int, val files: () -> Promise<List<File>>)

/**
 * The changes in a folder since the last look.
 *
 * @property changed the new and changed logs, which may still grow.
 * @property gone the paths of removed logs.
 * @property complete the paths of logs that had changed at the last look, but have not changed since.
 */
internal class FolderChanges(val changed: List<OpenedLog>, val gone: Set<String>, val complete: Set<String>) {
    val isSame: Boolean get() = changed.isEmpty() && gone.isEmpty() && complete.isEmpty()
}

/** The milliseconds to wait while the page is busy. */
private const val BUSY_PAUSE = 1000
