package badlog.viewer.takeaway

import badlog.viewer.app.NoticeAction
import badlog.viewer.app.Viewer
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.awt.Desktop
import java.awt.GraphicsEnvironment
import java.io.IOException
import java.nio.file.Path

/** What opens [place], a file or a folder, by the system's program for it; null where the system cannot. */
internal fun openAction(viewer: Viewer, place: Path): NoticeAction? {
    val canOpen = !GraphicsEnvironment.isHeadless() && Desktop.isDesktopSupported() &&
        Desktop.getDesktop().isSupported(Desktop.Action.OPEN)
    if (!canOpen) return null
    return NoticeAction("Open") {
        viewer.scope.launch {
            try {
                withContext(Dispatchers.IO) { Desktop.getDesktop().open(place.toFile()) }
            } catch (_: IOException) {
                viewer.notices.complain("The system has no program that opens $place; open it by hand.")
            } catch (_: IllegalArgumentException) {
                viewer.notices.complain("$place is not there any more.")
            }
        }
    }
}
