package badlog.viewer.text

import kotlin.math.floor

/** Returns [count] with separators between thousands, from five digits on. */
fun countText(count: Int): String {
    val digits = count.toString()
    if (digits.length <= GROUP + 1) return digits
    return buildString {
        digits.forEachIndexed { index, digit ->
            if (index > 0 && (digits.length - index) % GROUP == 0) append(' ')
            append(digit)
        }
    }
}

/** Returns a count with its noun: `1 graph`, `7 graphs`. */
fun countText(count: Int, one: String, many: String = one + "s"): String = "${countText(count)} ${if (count == 1) one else many}"

/** Returns the number of [shown] out of [all], with the noun [one]. For example `3 of 12 events`, or `12 events` if all are shown. */
fun countOf(shown: Int, all: Int, one: String): String = (if (shown == all) "" else "${countText(shown)} of ") + countText(all, one)

/** Returns a number of bytes with its unit, such as `2.4 MB`. */
fun bytesText(bytes: Double): String = when {
    bytes < 1000 -> "${bytes.toInt()} bytes"
    bytes < 999_950 -> "${fixedText(bytes / 1e3, 1)} kB"
    bytes < 999_950_000 -> "${fixedText(bytes / 1e6, 1)} MB"
    else -> "${fixedText(bytes / 1e9, 2)} GB"
}

/** Returns a duration in seconds with units, such as `2 min 30 s`. */
fun durationText(seconds: Double): String {
    if (seconds < SECONDS_OF_MINUTE) return "${exactText(floor(seconds * 100 + 0.5) / 100)} s"
    val whole = floor(seconds + 0.5).toInt()
    val minutes = whole / SECONDS_OF_MINUTE
    val hours = minutes / MINUTES_OF_HOUR
    if (hours > 0) return joined(hours, "h", minutes % MINUTES_OF_HOUR, "min")
    return joined(minutes, "min", whole % SECONDS_OF_MINUTE, "s")
}

private fun joined(large: Int, largeUnit: String, small: Int, smallUnit: String): String =
    "$large $largeUnit" + if (small > 0) " $small $smallUnit" else ""

private const val GROUP = 3
private const val SECONDS_OF_MINUTE = 60
private const val MINUTES_OF_HOUR = 60
