package badlog.formats

import badlog.core.recording.LogFormat
import badlog.formats.driverstation.DriverStationFormat
import badlog.formats.revlog.RevlogFormat
import badlog.formats.wpilog.WpilogFormat

/** The formats of this library, for programs that read any log. */
public val LOG_FORMATS: List<LogFormat> = listOf(WpilogFormat, DriverStationFormat, RevlogFormat)
