package badlog.viewer.text

import badlog.core.analysis.Units
import badlog.core.analysis.XAxis
import kotlin.math.abs

/** Returns [x] as a place on [axis], without the unit. The precision fits a screen that shows [width] of the axis. */
fun placeText(x: Double, axis: XAxis, width: Double): String = // There is nothing between two rows, so decimals would be meaningless.
    if (x.isNaN()) NO_NUMBER else fixedText(x, if (axis.isIndex) 0 else decimalsFor(width))

/**
 * Returns the cursor's place: `93.740 s · Teleop 1:31`. [clocks] is the time on other clocks; if it is empty, the place is also in minutes,
 * from one minute on.
 */
fun cursorText(x: Double, axis: XAxis, width: Double, clocks: String): String {
    val place = withUnit(placeText(x, axis, width), axis.unit)
    val seconds = Units.secondsIn(axis.unit)
    return when {
        clocks.isNotEmpty() -> "$place · $clocks"
        seconds != null && x.isFinite() && abs(x * seconds) >= SECONDS -> "$place · ${minutesText(x * seconds)}"
        else -> place
    }
}

/** Returns a length on [axis] with its unit, and also in minutes if it is a minute or more. */
fun lengthText(length: Double, axis: XAxis): String {
    val number = exactText(fixedText(length, decimalsFor(length)).toDouble())
    val name = lengthOn(axis, number)
    val seconds = Units.secondsIn(axis.unit)?.let { length * it } ?: 0.0
    return if (seconds >= SECONDS) "$name · ${minutesText(seconds)}" else name
}

/** Returns [number], a length on [axis], with its unit, which may be rows. */
internal fun lengthOn(axis: XAxis, number: String) = when {
    !axis.isIndex -> withUnit(number, axis.unit)
    number == "1" -> "1 row"
    else -> "$number rows"
}

/** Returns the difference between two places on [axis]: `Δ 1.5 s`, with a minus sign for a step back. */
fun differenceText(from: Double, to: Double, axis: XAxis): String {
    val sign = if (to < from) "-" else ""
    return "Δ $sign${lengthText(abs(to - from), axis)}"
}

/** Returns [seconds] in minutes, with hours if there are any: `1:33.7`, `1:02:05.0`. */
fun minutesText(seconds: Double, decimals: Int = 1): String {
    if (!(abs(seconds) < MAX_SECONDS)) return exactText(seconds)
    val text = fixedText(abs(seconds), decimals)
    val point = text.indexOf('.').let { if (it < 0) text.length else it }
    val whole = text.substring(0, point).toInt()
    val hours = whole / SECONDS / MINUTES
    val minutes = whole / SECONDS % MINUTES
    val sign = if (seconds < 0 && text.toDouble() > 0) "-" else ""
    val large = if (hours > 0) "$hours:${twoDigits(minutes)}" else "$minutes"
    return "$sign$large:${twoDigits(whole % SECONDS)}${text.substring(point)}"
}

/** Returns [number] with a zero in front if it has one digit. */
internal fun twoDigits(number: Int) = if (number < 10) "0$number" else "$number"

private const val SECONDS = 60
private const val MINUTES = 60
private const val MAX_SECONDS = 2e9

/** Returns [second] as `16 Mar 2024, 10:41`; it is in s since 1970 on a local wall clock. */
fun dateText(second: Long): String {
    val date = CivilDate.of(second.floorDiv(DAY))
    return "${date.day} ${MONTHS[date.month - 1]} ${date.year}, ${timeOfDay(second)}"
}

/** Returns [second], on the same clock, in ISO 8601, for searches: `2024-03-16T10:41`. */
fun isoText(second: Long): String {
    val date = CivilDate.of(second.floorDiv(DAY))
    return "${date.year}-${twoDigits(date.month)}-${twoDigits(date.day)}T${timeOfDay(second)}"
}

private fun timeOfDay(second: Long): String {
    val minutes = (second.mod(DAY) / MINUTE).toInt()
    return "${twoDigits(minutes / MINUTE)}:${twoDigits(minutes % MINUTE)}"
}

/** A day of the Gregorian calendar. */
private class CivilDate(val year: Int, val month: Int, val day: Int) {
    companion object {
        /** Returns the date [days] after 1 January 1970. Years are counted from March, so that the leap day is at their end. */
        fun of(days: Long): CivilDate {
            val since = days + DAYS_TO_1970
            val era = since.floorDiv(DAYS_OF_ERA)
            val ofEra = since.mod(DAYS_OF_ERA).toInt()
            val year = (ofEra - ofEra / 1460 + ofEra / 36524 - ofEra / 146096) / 365
            val dayOfYear = ofEra - (365 * year + year / 4 - year / 100)
            val marchMonth = (5 * dayOfYear + 2) / 153
            val month = if (marchMonth < 10) marchMonth + 3 else marchMonth - 9
            return CivilDate(
                year = (era * 400).toInt() + year + if (month <= 2) 1 else 0,
                month = month,
                day = dayOfYear - (153 * marchMonth + 2) / 5 + 1,
            )
        }
    }
}

private val MONTHS = listOf("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")
private const val MINUTE = 60
private const val DAY = 86400L
private const val DAYS_OF_ERA = 146097L

/** The days from 1 March of the year 0 to 1 January 1970. */
private const val DAYS_TO_1970 = 719468L
