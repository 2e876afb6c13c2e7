package badlog.viewer.shown.folder

import badlog.core.recording.Severity
import badlog.signals.match.NaturalOrder
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.ListedLog
import badlog.viewer.text.bytesText
import badlog.viewer.text.countText
import badlog.viewer.text.dateText

/**
 * The columns of the table of logs.
 *
 * @property title the heading.
 * @property order the order of the logs with a value.
 * @property isNumber whether the column is aligned to the right.
 * @property beginsDescending whether the first click sorts the largest to the top.
 * @property has returns whether a log has a value.
 * @property text returns the displayed text; null for a log without a value.
 */
enum class LogColumn(
    val title: String,
    val order: Comparator<ListedLog>,
    val isNumber: Boolean = false,
    val beginsDescending: Boolean = false,
    val has: (ListedLog) -> Boolean = { true },
    val text: (ListedLog) -> String?,
) {
    EVENT(
        "Event",
        compareBy(NaturalOrder) { it.summary.match.event.orEmpty() },
        has = { it.summary.match.event != null },
        text = { it.summary.match.event },
    ),
    TYPE(
        "Type",
        compareBy(NaturalOrder) { it.summary.match.type.orEmpty() },
        has = { it.summary.match.type != null },
        text = { it.summary.match.type },
    ),
    NUMBER(
        "Match",
        compareBy(NaturalOrder) { it.summary.match.number.orEmpty() },
        isNumber = true,
        has = { it.summary.match.number != null },
        text = { it.summary.match.number },
    ),
    ALLIANCE(
        "Alliance",
        compareBy(NaturalOrder) { it.summary.match.alliance.orEmpty() },
        has = { it.summary.match.alliance != null },
        text = { it.summary.match.alliance },
    ),
    DATE(
        "Date",
        compareBy { it.summary.date.second },
        beginsDescending = true,
        has = ::isDated,
        text = { if (isDated(it)) dateText(it.summary.date.second) else null },
    ),
    FINDINGS(
        "Findings",
        compareBy(
            { it.found?.count(Severity.ERROR) ?: 0 },
            { it.found?.count(Severity.WARNING) ?: 0 },
            { it.found?.count(Severity.NOTE) ?: 0 },
        ),
        beginsDescending = true,
        has = { foundText(it) != null },
        text = ::foundText,
    ),
    DURATION(
        "Duration",
        compareBy { it.summary.duration ?: 0.0 },
        isNumber = true,
        beginsDescending = true,
        has = { it.summary.duration != null },
        text = ::durationText,
    ),
    SAMPLES(
        "Samples",
        compareBy { it.summary.samples },
        isNumber = true,
        beginsDescending = true,
        text = { countText(it.summary.samples.toInt()) },
    ),
    SIZE(
        "Size",
        compareBy { it.size },
        isNumber = true,
        beginsDescending = true,
        text = { bytesText(it.size.toDouble()) },
    ),
    BATTERY(
        "Battery min",
        compareBy { it.summary.batteryMinimum ?: 0.0 },
        isNumber = true,
        has = { it.summary.batteryMinimum != null },
        text = ::batteryText,
    ),
    PROBLEMS(
        "Problems",
        compareBy({ !it.isReadable }, { it.summary.problems.errors }, { it.summary.problems.warnings }),
        isNumber = true,
        beginsDescending = true,
        has = { !it.isReadable || it.summary.problems.errors + it.summary.problems.warnings > 0 },
        text = ::problemText,
    ),
    FILE("File", compareBy(NaturalOrder) { it.path }, text = { it.fileName }),
}

// Some servers do not report when a file was written.
private fun isDated(log: ListedLog) = log.modified != 0L || log.summary.date.source != DateSource.FILE_TIME
