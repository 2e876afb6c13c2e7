package badlog.viewer.catalog

import badlog.core.analysis.firstText
import badlog.core.recording.Value
import badlog.signals.match.dateInName
import badlog.signals.match.dateInText
import badlog.signals.match.localSecondOf

/**
 * The time when a recording began.
 *
 * @property second the local time of the wall clock at the place of recording, in s since 1970 on that clock.
 * @property source the source of the time.
 */
data class LogDate(val second: Long, val source: DateSource) {
    companion object {
        /**
         * Returns the time when a recording with [values] began. Its file is called [name], and was last written at [modified], in ms since
         * 1970.
         */
        fun of(values: List<Value>, name: String, modified: Long): LogDate {
            val logged = values.firstText("start time", "start date", "date", "date time", "timestamp", "start")?.let(::dateInText)
            if (logged != null) return LogDate(logged, DateSource.VALUES)
            val named = dateInName(name)
            if (named != null) return LogDate(named.second, DateSource.FILE_NAME)
            return LogDate(localSecondOf(modified.floorDiv(MILLIS)), DateSource.FILE_TIME)
        }

        private const val MILLIS = 1000L
    }
}

/**
 * The source of a log's date.
 *
 * @property saying the displayed text.
 */
enum class DateSource(val saying: String) {
    VALUES("from the log’s metadata"),
    FILE_NAME("from the file’s name"),
    FILE_TIME("from the time when the file was written"),
}
