package badlog.viewer.compare

import badlog.viewer.app.Viewer
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** Saves [grid] as CSV into [file]. */
internal fun saveCsv(viewer: Viewer, grid: StatisticsGrid, file: Path) {
    viewer.tasks.run("Saving ${file.fileName}", { writeCsv(file, grid.toCsv()) }) {
        viewer.notices.say("The table is saved in $file.")
    }
}

private fun writeCsv(file: Path, csv: String) {
    try {
        Files.writeString(file, csv)
    } catch (e: IOException) {
        throw IOException("The table cannot be saved in $file; choose another folder (${e.message}).", e)
    }
}
