package badlog.window.task

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.awt.Desktop
import java.awt.GraphicsEnvironment
import java.io.IOException
import java.nio.file.Path

/**
 * Returns the action that opens [place] with the system's program for it; null if the system cannot. It runs in [scope]. [place] is a file
 * or a folder.
 */
internal fun openAction(place: Path, scope: CoroutineScope, notices: Notices): NoticeAction? {
    val canOpen = !GraphicsEnvironment.isHeadless() && Desktop.isDesktopSupported() &&
        Desktop.getDesktop().isSupported(Desktop.Action.OPEN)
    if (!canOpen) return null
    return NoticeAction("Open") {
        scope.launch {
            try {
                withContext(Dispatchers.IO) { Desktop.getDesktop().open(place.toFile()) }
            } catch (_: IOException) {
                notices.complain("The system has no program that opens $place; open it by hand.")
            } catch (_: IllegalArgumentException) {
                notices.complain("$place does not exist.")
            }
        }
    }
}
