package badlog.viewer.compare

import badlog.viewer.app.Viewer
import badlog.viewer.files.writeWhole
import java.nio.file.Path

/** Saves [grid] as CSV into [file]. */
internal fun saveCsv(viewer: Viewer, grid: StatisticsGrid, file: Path) {
    viewer.tasks.run("Saving ${file.fileName}", { writeWhole(file) { it.write(grid.toCsv().encodeToByteArray()) } }) {
        viewer.notices.say("The table is saved in $file.")
    }
}
