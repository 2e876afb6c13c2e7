package badlog.formats

import badlog.driverstation.DriverStationFormat
import badlog.recording.LogFormat
import badlog.wpilog.WpilogFormat

/** The formats of this library, for programs that read any log. */
public val LOG_FORMATS: List<LogFormat> = listOf(WpilogFormat, DriverStationFormat)
