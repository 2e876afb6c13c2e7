package badlog.viewer.text

import badlog.core.recording.PathName
import badlog.core.recording.Topic
import badlog.signals.fallsOf

/** Returns the question whether to draw a log over its time [column]; the log does not name an x axis. */
fun axisQuestion(column: Topic): String {
    val falls = fallsOf(column)
    val exceptions = if (falls == 0) "every row" else "all but ${countOf(falls, column.samples.size, "row")}"
    return "This log does not name an x axis. “${PathName.baseNameOf(column.name)}” increases in $exceptions."
}
