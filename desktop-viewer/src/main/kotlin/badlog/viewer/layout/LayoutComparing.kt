package badlog.viewer.layout

import badlog.viewer.app.Viewer
import badlog.viewer.compare.Alignment
import java.nio.file.Files

/** What lies over the open recording now, as a layout keeps it. */
internal fun comparisonOf(viewer: Viewer): LayoutComparison {
    val folder = viewer.library.folder
    val comparison = viewer.comparison
    return LayoutComparison(
        files = comparison.ticked.map { pathText(it, folder) },
        alignment = comparison.alignment.name,
        offsets = comparison.handOffsets.mapKeys { pathText(it.key, folder) },
    )
}

/** Lays over the open recording what [compared] names, as it was aligned; files that are gone are left out. */
internal fun restoreComparison(viewer: Viewer, compared: LayoutComparison) {
    val folder = viewer.library.folder
    fun fileOf(text: String) = pathOf(text, folder)?.toAbsolutePath()?.normalize()
    val files = compared.files.mapNotNull(::fileOf).distinct().filter(Files::isRegularFile)
    val offsets = compared.offsets.entries.mapNotNull { (text, offset) -> fileOf(text)?.let { it to offset } }
    viewer.comparison.ticked.filter { it !in files }.forEach(viewer.comparisonLoading::remove)
    files.filter { it !in viewer.comparison.ticked }.forEach(viewer.comparisonLoading::add)
    viewer.comparison = viewer.comparison.copy(
        alignment = Alignment.entries.find { it.name == compared.alignment } ?: Alignment.START,
        handOffsets = offsets.toMap(),
    )
}
