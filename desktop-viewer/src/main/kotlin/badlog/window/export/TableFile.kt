package badlog.window.export

import badlog.files.writeAtomically
import badlog.viewer.shown.table.CsvDraft
import badlog.viewer.text.countText
import badlog.window.log.OpenRecording
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * Writes the table of [draft], a part of [recording], to [target].
 *
 * @return a sentence about the written rows.
 * @throws IOException with a sentence for the user, if there is nothing to write or [target] is the recording's own file.
 */
internal fun tableFile(recording: OpenRecording, draft: CsvDraft, target: Path, progress: (Float) -> Unit = {}): String {
    while (draft.step()) {
        if (Thread.interrupted()) throw InterruptedException()
        progress(draft.share.toFloat() * PREPARED)
    }
    val table = draft.table
    requireOther(recording, table.rowCount, target)
    writeAtomically(target) { out ->
        out.write(table.header.encodeToByteArray())
        for (row in 0 until table.rowCount step ROWS) {
            if (Thread.interrupted()) throw InterruptedException()
            progress(PREPARED + (1 - PREPARED) * row / table.rowCount)
            out.write(table.text(row, ROWS).encodeToByteArray())
        }
    }
    return "Wrote ${countText(table.rowCount, "row")} to $target${table.remark}."
}

/** @throws IOException if there are no [rows], or [target] is the file of [recording] itself. The message is a sentence for the user. */
internal fun requireOther(recording: OpenRecording, rows: Int, target: Path) {
    if (rows == 0) throw IOException("There are no samples in the visible range; show a part of the log that has some.")
    if (Files.exists(target) && Files.exists(recording.file) && Files.isSameFile(target, recording.file)) {
        throw IOException("${target.fileName} is the open log itself; select another name.")
    }
}

private const val ROWS = 2000

/** The progress at which the writing of rows begins. */
private const val PREPARED = 0.2f
