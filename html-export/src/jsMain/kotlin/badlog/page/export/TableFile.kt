package badlog.page.export

import badlog.page.dom.saveFile
import badlog.page.view.Notice
import badlog.page.view.Scene
import badlog.plot.table.CsvTable
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.files.Blob
import org.w3c.files.BlobPropertyBag
import kotlin.js.Date
import kotlin.js.Promise

/**
 * Promises [table] as a file. It is made in slices, so that the page stays responsive: if one slice is not enough, [notice] shows the
 * progress. Closing the notice cancels the work; the result is then null.
 */
internal fun fileOf(table: CsvTable, notice: Notice): Promise<Blob?> = Promise { resolve, _ -> TableSlices(table, notice, resolve).next() }

/** Saves [table] under [name], and says how its rows were made if the log has none. */
internal fun saveTable(scene: Scene, name: String, table: CsvTable) {
    if (table.rowCount == 0) return scene.notice.say("There are no samples in the visible range; show a part of the log that has some.")
    fileOf(table, scene.notice).then { file ->
        if (file == null) return@then
        saveFile(file, fileNameOf(scene, name, ".csv"))
        if (table.remark.isNotEmpty()) scene.notice.say("Saved ${table.rowCount} rows${table.remark}.")
    }
}

private class TableSlices(private val table: CsvTable, private val notice: Notice, private val done: (Blob?) -> Unit) {
    private val parts = arrayListOf(Blob(arrayOf(table.header)))
    private var row = 0

    /** The number of rows made at a time: a row may have one cell, or thousands. */
    private var rows = 1
    private var isCancelled = false

    fun next() {
        if (isCancelled) return done(null)
        val texts = ArrayList<String>()
        // A browser runs the timers of a hidden page only once a second.
        val end = Date.now() + if (document.asDynamic().hidden == true) HIDDEN_SLICE else SLICE
        do {
            val begin = Date.now()
            texts += table.text(row, rows)
            row += rows
            if (Date.now() - begin < FEW) rows *= 2
        } while (row < table.rowCount && Date.now() < end)
        parts += Blob(texts.toTypedArray())
        if (row < table.rowCount) {
            val tenths = (row / (table.rowCount / TENTHS)).toInt()
            notice.show("Making the table: ${tenths * 10} %") { isCancelled = true }
            window.setTimeout(::next, 0)
        } else {
            notice.hide()
            done(Blob(parts.toTypedArray(), BlobPropertyBag("text/csv")))
        }
    }

    private companion object {
        /** In milliseconds. */
        const val SLICE = 40
        const val HIDDEN_SLICE = 800
        const val FEW = 5
        const val TENTHS = 10.0
    }
}
