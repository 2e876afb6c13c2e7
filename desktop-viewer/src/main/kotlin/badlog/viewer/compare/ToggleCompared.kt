package badlog.viewer.compare

import badlog.viewer.app.Viewer
import java.nio.file.Path

/** Lays the recording of [file] over the open one, or takes it away when it lies there. */
internal fun toggleCompared(viewer: Viewer, file: Path) {
    val ticked = viewer.comparison.ticked
    viewer.comparison = viewer.comparison.copy(ticked = if (file in ticked) ticked.filter { it != file } else ticked + listOf(file))
}
