package badlog.page.opened

import badlog.page.screen.isPageBusy
import kotlinx.browser.window
import org.w3c.files.File
import kotlin.js.Promise

/**
 * Looks into a folder from time to time.
 *
 * @param known returns the log at a path as it was when the folder was last looked into; null if there was none.
 * @param onLook called after each look.
 */
internal class FolderWatch(
    private val folder: FolderAgain,
    private val known: Map<String, OpenedLog>,
    private val onLook: (FolderLook) -> Unit,
) {
    /** The logs that had changed when the folder was last looked into. */
    private val growing = HashSet<String>()
    private var timer = 0
    private var isOver = false

    /** Starts, unless it has been started. */
    fun start() {
        if (timer == 0) lookIn(folder.pause)
    }

    private fun lookIn(pause: Int) {
        timer = window.setTimeout({
            // A log that a person waits for comes first.
            if (isPageBusy) return@setTimeout lookIn(BUSY_PAUSE)
            // What cannot be listed now is looked for again later.
            folder.files().then({ if (!isOver) onLook(compare(OpenedLog.logsIn(it))) }, {})
                .catch { console.error(it) }
                .then { if (!isOver) lookIn(folder.pause) }
        }, pause)
    }

    /** Returns whether the log at [path] had changed when the folder was last looked into. */
    fun isGrowing(path: String): Boolean = path in growing

    /** Ends it. */
    fun stop() {
        isOver = true
        window.clearTimeout(timer)
    }

    private fun compare(logs: List<OpenedLog>): FolderLook {
        val changed = logs.filter { log -> known[log.path].let { it == null || it.size != log.size || it.modified != log.modified } }
        val gone = known.keys - logs.mapTo(HashSet()) { it.path }
        // A browser does not read a file that is written meanwhile: a log is read when it has stopped growing.
        val complete = growing - changed.mapTo(HashSet()) { it.path } - gone
        growing.clear()
        changed.mapTo(growing) { it.path }
        return FolderLook(changed, gone, complete)
    }

    private companion object {
        /** Milliseconds until a page may no longer be busy. */
        const val BUSY_PAUSE = 1000
    }
}

/**
 * A folder into which the page can look again.
 *
 * @property pause milliseconds between two looks.
 * @property files promises the files that are in it now.
 */
internal class FolderAgain(val pause: Int, val files: () -> Promise<List<File>>)

/**
 * What is different in a folder since the last look.
 *
 * @property changed the logs that are new or have grown, which may still grow.
 * @property gone the paths of those that are no longer there.
 * @property complete the paths of those that had changed before, and have not since.
 */
internal class FolderLook(val changed: List<OpenedLog>, val gone: Set<String>, val complete: Set<String>) {
    /** Whether nothing is different. */
    val isSame: Boolean get() = changed.isEmpty() && gone.isEmpty() && complete.isEmpty()
}
