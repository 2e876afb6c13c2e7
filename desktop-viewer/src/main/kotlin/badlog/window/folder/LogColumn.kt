package badlog.window.folder

import badlog.catalog.folder.LogEntry
import badlog.core.recording.Severity
import badlog.files.NaturalOrder

/**
 * The columns of the table of logs.
 *
 * @property title its heading.
 * @property width its width, in dp.
 * @property order the order of those logs that have it.
 * @property isNumber whether it is aligned to the right.
 * @property beginsDescending whether the first click sorts the largest to the top.
 * @property has returns whether a log has it at all.
 * @property text returns its text for people; null for a log that has none.
 */
internal enum class LogColumn(
    val title: String,
    val width: Int,
    val order: Comparator<LogEntry>,
    val isNumber: Boolean = false,
    val beginsDescending: Boolean = false,
    val has: (LogEntry) -> Boolean = { true },
    val text: (LogEntry) -> String?,
) {
    EVENT(
        "Event",
        160,
        compareBy(NaturalOrder) { it.summary.match.event.orEmpty() },
        has = { it.summary.match.event != null },
        text = { it.summary.match.event },
    ),
    TYPE(
        "Type",
        104,
        compareBy(NaturalOrder) { it.summary.match.type.orEmpty() },
        has = { it.summary.match.type != null },
        text = { it.summary.match.type },
    ),
    NUMBER(
        "Match",
        64,
        compareBy(NaturalOrder) { it.summary.match.number.orEmpty() },
        isNumber = true,
        has = { it.summary.match.number != null },
        text = { it.summary.match.number },
    ),
    ALLIANCE(
        "Alliance",
        72,
        compareBy(NaturalOrder) { it.summary.match.alliance.orEmpty() },
        has = { it.summary.match.alliance != null },
        text = { it.summary.match.alliance },
    ),
    DATE("Date", 164, compareBy { it.summary.date.second }, beginsDescending = true, text = { dateText(it.summary.date) }),
    FINDINGS(
        "Findings",
        190,
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
        80,
        compareBy { it.summary.duration ?: 0.0 },
        isNumber = true,
        beginsDescending = true,
        has = { it.summary.duration != null },
        text = ::durationText,
    ),
    SAMPLES(
        "Samples",
        96,
        compareBy { it.summary.samples },
        isNumber = true,
        beginsDescending = true,
        text = { "%,d".format(ENGLISH, it.summary.samples) },
    ),
    SIZE(
        "Size",
        80,
        compareBy { it.source.size },
        isNumber = true,
        beginsDescending = true,
        text = { sizeText(it.source.size) },
    ),
    BATTERY(
        "Battery min",
        100,
        compareBy { it.summary.batteryMinimum ?: 0.0 },
        isNumber = true,
        has = { it.summary.batteryMinimum != null },
        text = ::batteryText,
    ),
    PROBLEMS(
        "Problems",
        104,
        compareBy({ !it.isReadable }, { it.summary.problems.errors }, { it.summary.problems.warnings }),
        isNumber = true,
        beginsDescending = true,
        has = { !it.isReadable || it.summary.problems.errors + it.summary.problems.warnings > 0 },
        text = ::problemText,
    ),
    FILE("File", 240, compareBy(NaturalOrder) { it.file.toString() }, text = { it.fileName }),
}
