package badlog.formats.driverstation

import badlog.formats.wpilog.WpilogFormat
import badlog.formats.wpilog.WpilogParser

/** The number of first bytes from which [stationStartIn] returns the time. */
public const val STATION_HEAD_SIZE: Int = 1 shl 16

/**
 * Returns when a log of the Driver Station began, in s since 1970, by its first bytes. Null if they do not show it. Until 2026, the header
 * has it; from 2027 on, its clock and the time of day are in the same record from time to time.
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
