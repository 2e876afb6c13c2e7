package badlog.viewer.compare

import badlog.viewer.app.Viewer
import java.nio.file.Path

/** Ticks the recording in [file], or takes its tick away. */
internal fun toggleCompared(viewer: Viewer, file: Path) {
    val known = file.toAbsolutePath().normalize()
    if (known in viewer.comparison.ticked) viewer.comparisonLoading.remove(known) else viewer.comparisonLoading.add(known)
}
