package badlog.viewer.shown.folder

import badlog.core.recording.Severity
import badlog.signals.match.NaturalOrder
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.ListedLog
import badlog.viewer.text.bytesText
import badlog.viewer.text.countText
import badlog.viewer.text.dateText

/**
 * The columns of the table of logs, in order: the match and what happened first, the file last.
 *
 * @property title the heading.
 * @property order the order of the logs.
 * @property isNumber whether the column is aligned to the right.
 * @property beginsDescending whether the first click sorts the largest to the top.
 * @property text returns the displayed text; null for a log without a value.
 */
enum class LogColumn(
    val title: String,
    val order: Comparator<ListedLog>,
    val isNumber: Boolean = false,
    val beginsDescending: Boolean = false,
    val text: (ListedLog) -> String?,
) {
    MATCH(
        "Match",
        compareBy<ListedLog, String>(NaturalOrder) {
            it.summary.match.title.orEmpty()
        }.thenBy(NaturalOrder) { it.path },
        text = { shortTitle(it.summary.match) },
    ),
    FINDINGS(
        "What happened",
        compareBy(
            { it.found?.count(Severity.ERROR) ?: 0 },
            { it.found?.count(Severity.WARNING) ?: 0 },
            { it.found?.count(Severity.NOTE) ?: 0 },
        ),
        beginsDescending = true,
        text = ::foundText,
    ),
    DATE(
        "Time",
        compareBy { it.summary.date.second },
        beginsDescending = true,
        // Some servers do not report when a file was written.
        text = { log ->
            dateText(log.summary.date.second).takeIf { log.modified != 0L || log.summary.date.source != DateSource.FILE_TIME }
        },
    ),
    DURATION(
        "Duration",
        compareBy { it.summary.duration ?: 0.0 },
        isNumber = true,
        beginsDescending = true,
        text = ::durationText,
    ),
    BATTERY("Lowest battery", compareBy { it.summary.batteryMinimum ?: 0.0 }, isNumber = true, text = ::batteryText),
    PROBLEMS(
        "Problems",
        compareBy({ !it.isReadable }, { it.summary.problems.errors }, { it.summary.problems.warnings }),
        beginsDescending = true,
        text = ::problemText,
    ),
    ALLIANCE("Alliance", compareBy(NaturalOrder) { it.summary.match.alliance.orEmpty() }, text = { it.summary.match.alliance }),
    SAMPLES(
        "Samples",
        compareBy { it.summary.samples },
        isNumber = true,
        beginsDescending = true,
        text = { countText(it.summary.samples.toInt()) },
    ),
    SIZE("Size", compareBy { it.size }, isNumber = true, beginsDescending = true, text = { bytesText(it.size.toDouble()) }),
    FILE("File", compareBy(NaturalOrder) { it.path }, text = { it.fileName }),
    ;

    /** Returns whether [log] has a value. */
    fun has(log: ListedLog): Boolean = text(log) != null
}
