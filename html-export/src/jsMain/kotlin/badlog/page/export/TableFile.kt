package badlog.page.export

import badlog.page.dom.saveFile
import badlog.page.view.Scene
import badlog.plot.table.CsvTable
import org.w3c.files.Blob
import org.w3c.files.BlobPropertyBag

/** [table] as a file. */
internal fun fileOf(table: CsvTable): Blob {
    val parts = (0 until table.rowCount step ROWS).map { table.text(it, ROWS) }
    return Blob((listOf(table.header) + parts).toTypedArray(), BlobPropertyBag("text/csv"))
}

/** Saves [table], which is called [name], and says how its rows came about where the log has none. */
internal fun saveTable(scene: Scene, name: String, table: CsvTable) {
    if (table.rowCount == 0) return scene.notice.say("There are no samples in the visible range; show a part of the log that has some.")
    saveFile(fileOf(table), fileNameOf(scene, name, ".csv"))
    if (table.remark.isNotEmpty()) scene.notice.say("Saved ${table.rowCount} rows${table.remark}.")
}

private const val ROWS = 2000
