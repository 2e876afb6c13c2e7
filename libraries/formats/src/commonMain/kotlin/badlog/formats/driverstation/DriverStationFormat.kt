package badlog.formats.driverstation

import badlog.core.recording.LogFormat
import badlog.core.recording.LogParser

/** The logs of the FRC Driver Station: a `.dslog`, a `.dsevents`, or the bytes of both, in this order. */
public object DriverStationFormat : LogFormat {
    /** The ending of a log's first file, which holds the measured values. */
    public const val FIRST_ENDING: String = ".dslog"

    /** The ending of a log's second file, which holds messages. Without the ending, both files have the same name. */
    public const val SECOND_ENDING: String = ".dsevents"

    override val id: String get() = "driver_station"

    override val title: String get() = "Driver Station log"

    override val endings: List<String> get() = listOf(FIRST_ENDING, SECOND_ENDING)

    override val signatureSize: Int get() = SIGNATURE_SIZE

    override fun matches(bytes: ByteArray, size: Int): Boolean = size >= SIGNATURE_SIZE && isHeader(bytes, 0)

    override fun parser(keepSamples: Boolean): LogParser = DriverStationParser(keepSamples)

    /** The number of bytes that [startOf] needs. */
    public const val HEAD_SIZE: Int = HEADER_SIZE

    /** Returns the start of the log with the first [HEAD_SIZE] bytes [head], in s since 1970. Null if it is not such a log. */
    public fun startOf(head: ByteArray): Double? = if (head.size < HEAD_SIZE || !isHeader(head, 0)) {
        null
    } else {
        secondsAt(head, Int.SIZE_BYTES) + fractionAt(head, Int.SIZE_BYTES) - SECONDS_TO_1970
    }
}

/** The seconds from the start of 1904, from which Driver Stations count, to the start of 1970. */
internal const val SECONDS_TO_1970 = 2082844800.0

/** The size of a header in bytes: a version, the seconds since 1904 and their fraction. */
internal const val HEADER_SIZE = 20

/** The number of bytes that [isHeader] needs: a version and the highest byte of a time from 2006 until 2040. */
internal const val SIGNATURE_SIZE = 9

/** Returns whether a file begins at [at] of [bytes]; [SIGNATURE_SIZE] bytes must follow. No record begins like that. */
internal fun isHeader(bytes: ByteArray, at: Int): Boolean =
    wordAt(bytes, at) in 0..MAX_VERSION && wordAt(bytes, at + 4) == 0 && bytes[at + 8] in LATE_YEARS

private const val MAX_VERSION = 9
private val LATE_YEARS = -64..-1
