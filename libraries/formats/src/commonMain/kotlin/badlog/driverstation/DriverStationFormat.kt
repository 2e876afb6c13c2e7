package badlog.driverstation

import badlog.recording.LogFormat
import badlog.recording.LogParser

/** The logs of the FRC Driver Station: a `.dslog`, a `.dsevents`, or the bytes of the first and then those of the second. */
public object DriverStationFormat : LogFormat {
    override val signatureSize: Int get() = SIGNATURE_SIZE

    override fun matches(bytes: ByteArray, size: Int): Boolean = size >= SIGNATURE_SIZE && isHeader(bytes, 0)

    override fun parser(keepSamples: Boolean): LogParser = DriverStationParser(keepSamples)

    /** How many bytes [startOf] needs. */
    public const val HEAD_SIZE: Int = HEADER_SIZE

    /** When the log began whose first [HEAD_SIZE] bytes are [head], in s since 1970; null where those are not of such a log. */
    public fun startOf(head: ByteArray): Double? = if (head.size < HEAD_SIZE ||
        !isHeader(head, 0)
    ) {
        null
    } else {
        secondsAt(head, Int.SIZE_BYTES) + fractionAt(head, Int.SIZE_BYTES) - SECONDS_TO_1970
    }
}

/** From the beginning of 1904, from which Driver Stations count, to that of 1970. */
internal const val SECONDS_TO_1970 = 2082844800.0

/** Version, the seconds since 1904 and their fraction. */
internal const val HEADER_SIZE = 20

/** A version and the highest byte of a time from 2006 until 2040. */
internal const val SIGNATURE_SIZE = 9

/** Whether a file begins at [at] of [bytes], from where on [SIGNATURE_SIZE] bytes are there. No record begins so. */
internal fun isHeader(bytes: ByteArray, at: Int): Boolean =
    wordAt(bytes, at) in 0..MAX_VERSION && wordAt(bytes, at + 4) == 0 && bytes[at + 8] in LATE_YEARS

private const val MAX_VERSION = 9
private val LATE_YEARS = -64..-1
