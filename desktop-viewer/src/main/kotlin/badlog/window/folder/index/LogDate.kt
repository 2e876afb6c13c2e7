package badlog.window.folder.index

import badlog.core.analysis.meant
import badlog.core.recording.Value
import badlog.files.LogFile
import badlog.files.dateInName
import badlog.files.dateInText
import java.time.Instant
import java.time.LocalDateTime
import java.time.ZoneId
import java.time.ZoneOffset

/**
 * When a recording began.
 *
 * @property second the local wall clock time where it was made, as seconds since 1970 without an offset.
 * @property source its source.
 */
internal data class LogDate(val second: Long, val source: DateSource) {
    /** The date as local time. */
    val time: LocalDateTime get() = LocalDateTime.ofEpochSecond(second, 0, ZoneOffset.UTC)

    companion object {
        /** Returns when the recording of [file], with [values], began. */
        fun of(values: List<Value>, file: LogFile): LogDate {
            val logged = values.meant("start time", "start date", "date", "date time", "timestamp", "start")?.let(::dateInText)
            if (logged != null) return of(logged, DateSource.VALUES)
            return ofFile(file)
        }

        /** Returns the date from [file] alone. */
        fun ofFile(file: LogFile): LogDate {
            val named = dateInName(file.name)
            if (named != null) return of(named.time, DateSource.FILE_NAME)
            val written = LocalDateTime.ofInstant(Instant.ofEpochMilli(file.modified), ZoneId.systemDefault())
            return of(written, DateSource.FILE_TIME)
        }

        private fun of(time: LocalDateTime, source: DateSource) = LogDate(time.toEpochSecond(ZoneOffset.UTC), source)
    }
}

/**
 * The source of a log's date.
 *
 * @property saying its text for people.
 */
internal enum class DateSource(val saying: String) {
    VALUES("from the log’s metadata"),
    FILE_NAME("from the file’s name"),
    FILE_TIME("from the time when the file was written"),
}
