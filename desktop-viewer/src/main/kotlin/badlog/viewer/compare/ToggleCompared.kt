package badlog.viewer.compare

import badlog.viewer.app.Viewer
import java.nio.file.Path

/** Lays the recording of [file] over the open one, or takes it away when it lies there. */
internal fun toggleCompared(viewer: Viewer, file: Path) {
    val ticked = viewer.comparison.ticked
    val others = ticked.filter { it != file }
    viewer.comparison = viewer.comparison.copy(ticked = if (file in ticked) others else ticked + listOf(file))
}
