package badlog.window.layout

import badlog.viewer.choices.comparison.LogOffsets
import badlog.window.compare.ComparedRecordings
import java.nio.file.Files
import java.nio.file.Path

/** Compares the open recording with the files in [layout] of [folder], as they were aligned; missing files are skipped. */
internal fun ComparedRecordings.restore(layout: LayoutComparison, folder: Path?) {
    fun fileOf(text: String) = pathOf(text, folder)?.toAbsolutePath()?.normalize()
    val files = layout.files.mapNotNull(::fileOf).distinct().filter(Files::isRegularFile)
    val offsets = layout.offsets.entries.mapNotNull { (text, offset) -> fileOf(text)?.let { it to offset } }
    state.checked.filter { it !in files }.forEach(::remove)
    files.filter { it !in state.checked }.forEach(::add)
    change { copy(offsets = LogOffsets(alignmentOf(layout), offsets.toMap())) }
}
