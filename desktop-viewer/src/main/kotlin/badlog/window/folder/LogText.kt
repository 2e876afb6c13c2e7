package badlog.window.folder

import badlog.viewer.shown.folder.LogColumn
import java.util.Locale

/** The window's language. */
internal val ENGLISH: Locale = Locale.ENGLISH

/** The width of this column, in dp. */
internal val LogColumn.width: Int
    get() = when (this) {
        LogColumn.EVENT -> 160
        LogColumn.TYPE -> 104
        LogColumn.NUMBER -> 64
        LogColumn.ALLIANCE -> 72
        LogColumn.DATE -> 164
        LogColumn.FINDINGS -> 190
        LogColumn.DURATION -> 80
        LogColumn.SAMPLES -> 96
        LogColumn.SIZE -> 80
        LogColumn.BATTERY -> 100
        LogColumn.PROBLEMS -> 104
        LogColumn.FILE -> 240
    }
