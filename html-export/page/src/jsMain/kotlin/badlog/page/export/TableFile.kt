package badlog.page.export

import badlog.page.dom.saveFile
import badlog.page.dom.sliceMillis
import badlog.page.view.Notice
import badlog.page.view.Scene
import badlog.viewer.shown.table.CsvDraft
import badlog.viewer.text.countText
import kotlinx.browser.window
import org.w3c.files.Blob
import org.w3c.files.BlobPropertyBag
import kotlin.js.Date
import kotlin.js.Promise

/**
 * Promises the table of [draft] as a file; null if the work is canceled. It is made in slices, so that the page stays responsive. If one
 * slice is not enough, [notice] shows the progress; closing the notice cancels the work.
 */
internal fun fileOf(draft: CsvDraft, notice: Notice): Promise<Blob?> = Promise { resolve, _ -> TableSlices(draft, notice, resolve).next() }

/** Saves the table of [draft] under [name]. If the log itself has no rows, shows how these were made. */
internal fun saveTable(scene: Scene, name: String, draft: CsvDraft) {
    fileOf(draft, scene.notice).then { file ->
        if (file == null) return@then
        val table = draft.table
        if (table.rowCount == 0) {
            scene.notice.say("There are no samples in the visible range; show a part of the log that has some.")
        } else {
            saveFile(file, fileNameOf(scene, name, ".csv"))
            if (table.remark.isNotEmpty()) scene.notice.say("Saved ${countText(table.rowCount, "row")}${table.remark}.")
        }
    }
}

private class TableSlices(private val draft: CsvDraft, private val notice: Notice, private val done: (Blob?) -> Unit) {
    private val parts = ArrayList<Blob>()
    private var row = 0

    /** The number of rows made at a time, because a row may have one cell or thousands. */
    private var rows = 1
    private var isCancelled = false

    fun next() {
        if (isCancelled) return done(null)
        val end = Date.now() + sliceMillis(SLICE)
        while (draft.step()) if (Date.now() > end) return continueLater("Preparing", draft.share)
        val table = draft.table
        val texts = arrayListOf(if (parts.isEmpty()) table.header else "")
        do {
            val begin = Date.now()
            texts += table.text(row, rows)
            row += rows
            if (Date.now() - begin < FAST_MILLISECONDS) rows *= 2
        } while (row < table.rowCount && Date.now() < end)
        parts += Blob(texts.toTypedArray())
        if (row < table.rowCount) return continueLater("Making", row.toDouble() / table.rowCount)
        notice.hide()
        done(Blob(parts.toTypedArray(), BlobPropertyBag("text/csv")))
    }

    private fun continueLater(what: String, share: Double) {
        notice.show("$what the table: ${(share * TENTHS).toInt() * 10} %") { isCancelled = true }
        window.setTimeout(::next, 0)
    }
}

/** The duration of a slice, in milliseconds. */
private const val SLICE = 40
private const val FAST_MILLISECONDS = 5
private const val TENTHS = 10.0
