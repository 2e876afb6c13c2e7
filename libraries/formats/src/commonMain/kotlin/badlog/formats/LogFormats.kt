package badlog.formats

import badlog.core.recording.LogFormat
import badlog.core.recording.RecordingFormat
import badlog.formats.driverstation.DriverStationFormat
import badlog.formats.list.ListFormat
import badlog.formats.revlog.RevlogFormat
import badlog.formats.wpilog.WpilogFormat

/** The formats of this library, for programs that read any log. */
public val LOG_FORMATS: List<LogFormat> = listOf(WpilogFormat, DriverStationFormat, RevlogFormat, ListFormat)

private val TEXT_FORMATS = listOf(RecordingFormat.BAG, RecordingFormat.CSV)

/** All formats that a recording may have been read from. */
public val RECORDING_FORMATS: List<RecordingFormat> = TEXT_FORMATS + LOG_FORMATS

/** The endings of logs that are text, which `core` reads: bags and CSV files. */
public val TEXT_ENDINGS: List<String> = TEXT_FORMATS.flatMap { it.endings }

/** The endings of all logs that can be read, in lower case, each with its dot. */
public val LOG_ENDINGS: List<String> = RECORDING_FORMATS.flatMap { it.endings }.distinct()

/** The readable kinds of logs and their endings, as a part of a sentence: “bags (.bag), …, and REV logs (.revlog)”. */
public val READABLE_LOGS: String = (TEXT_FORMATS + LOG_FORMATS.filterNot { TEXT_ENDINGS.containsAll(it.endings) })
    .map { "${it.title}s (${it.endings.joinToString()})" }
    .run { dropLast(1).joinToString() + ", and " + last() }
