package badlog.formats.driverstation

import badlog.formats.wpilog.WpilogFormat
import badlog.formats.wpilog.WpilogParser

/** The number of bytes at a file's start that [stationStartIn] needs. */
public const val STATION_HEAD_SIZE: Int = 1 shl 16

/**
 * Returns the start of a Driver Station log, in s since 1970, from its first bytes, [head]. Null if they do not show it. Until 2026, the
 * header has this time; from 2027 on, some records have both the log's clock and the time of day.
 */
public fun stationStartIn(head: ByteArray): Double? = when {
    WpilogFormat.matches(head, head.size) -> WpilogParser().run {
        accept(head, 0, head.size)
        finish()
        startMicros?.div(MICROS)
    }

    else -> DriverStationFormat.startOf(head)
}

private const val MICROS = 1e6
