package badlog.viewer.layout

import badlog.viewer.app.Viewer
import java.nio.file.Files

/** What lies over the open recording now, as a layout keeps it. */
internal fun comparisonOf(viewer: Viewer): LayoutComparison {
    val folder = viewer.library.folder
    return LayoutComparison(files = viewer.comparison.ticked.map { pathText(it, folder) })
}

/** Lays over the open recording what [compared] names; files that are gone are left out. */
internal fun restoreComparison(viewer: Viewer, compared: LayoutComparison) {
    val folder = viewer.library.folder
    val files = compared.files.mapNotNull { pathOf(it, folder) }.distinct().filter(Files::isRegularFile)
    viewer.comparison = viewer.comparison.copy(ticked = files)
}
