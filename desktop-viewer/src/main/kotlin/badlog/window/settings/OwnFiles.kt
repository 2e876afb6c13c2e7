package badlog.window.settings

import badlog.files.UserFolders
import badlog.window.files.obstacleTo
import badlog.window.task.Notices
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * The files that badlog keeps for its next start. Use it only on the window's thread. The window works without them; a single sentence
 * reports the data that is not kept.
 *
 * @property folders the folders of these files.
 */
internal class OwnFiles(val folders: UserFolders, private val notices: Notices) {
    private var isReported = false

    /** Reports the data that cannot be kept, if a folder cannot be written. */
    suspend fun check() {
        val (settings, answers) = withContext(Dispatchers.IO) { obstacleTo(folders.settings) to obstacleTo(folders.answers) }
        if (settings != null) isReported = true
        val obstacles = listOfNotNull(settings, answers).distinct()
        val lost = when {
            obstacles.isEmpty() -> return
            answers == null -> "Settings and layouts"
            settings == null -> "Stored results for logs"
            else -> "Settings, layouts and stored results for logs"
        }
        notices.complain("$lost cannot be kept for the next start; ${obstacles.joinToString(" and ", transform = ::remedyFor)}.")
    }

    /** Reports the failure [e] to save settings or layouts, unless one was reported before. */
    suspend fun cannotSave(e: IOException) {
        if (!isReported) check()
        if (isReported) return
        isReported = true
        notices.complain("Settings and layouts cannot be saved: ${e.message}")
    }
}

private fun remedyFor(obstacle: Path) = if (Files.isDirectory(obstacle)) {
    "change the permissions of $obstacle, so that you may write there"
} else {
    "rename the file $obstacle, because a folder must be there"
}
