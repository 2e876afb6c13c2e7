package badlog.page.opened

import badlog.page.screen.isPageBusy
import kotlinx.browser.window
import org.w3c.files.File
import kotlin.js.Promise

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

    private companion object {
        /** The milliseconds to wait while the page is busy. */
        const val BUSY_PAUSE = 1000
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
