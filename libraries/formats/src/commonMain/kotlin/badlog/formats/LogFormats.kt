package badlog.formats

import badlog.core.recording.LogFormat
import badlog.formats.driverstation.DriverStationFormat
import badlog.formats.revlog.RevlogFormat
import badlog.formats.wpilog.WpilogFormat

/** The formats of this library, for programs that read any log. */
public val LOG_FORMATS: List<LogFormat> = listOf(WpilogFormat, DriverStationFormat, RevlogFormat)

/** The endings of logs that are text, which `core` reads: bags and CSV files. */
public val TEXT_ENDINGS: List<String> = listOf(".bag", ".badbag", ".csv")

/** The endings of all logs that can be read, in lower case, each with its dot. */
public val LOG_ENDINGS: List<String> = TEXT_ENDINGS + LOG_FORMATS.flatMap { it.endings }

/** The kinds of logs that can be read and their endings, as a part of a sentence: “bags (.bag), …, and REV logs (.revlog)”. */
public val READABLE_LOGS: String = "bags (.bag, .badbag), CSV files (.csv)" +
    LOG_FORMATS.withIndex().joinToString("") { (i, format) ->
        (if (i < LOG_FORMATS.lastIndex) ", " else ", and ") + "${format.title}s (${format.endings.joinToString()})"
    }
