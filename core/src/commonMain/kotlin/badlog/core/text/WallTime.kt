package badlog.core.text

import kotlin.math.floor

/** Returns the moment [micros] µs after the start of 1970, in UTC: `2024-03-09 14:02:31 UTC`. Null outside the years 1970 to 9999. */
public fun wallTimeText(micros: Double): String? {
    if (!(micros >= 0 && micros < END_OF_9999)) return null
    val seconds = floor(micros / 1e6)
    val days = floor(seconds / DAY).toInt()
    val ofDay = (seconds - days * DAY).toInt()
    // Counting years from March puts the leap day at the end (Hinnant, "chrono-compatible low-level date algorithms").
    val shifted = days + DAYS_TO_1970
    val era = shifted / DAYS_OF_ERA
    val dayOfEra = shifted % DAYS_OF_ERA
    val yearOfEra = (dayOfEra - dayOfEra / 1460 + dayOfEra / 36524 - dayOfEra / 146096) / 365
    val dayOfYear = dayOfEra - (365 * yearOfEra + yearOfEra / 4 - yearOfEra / 100)
    val month = (5 * dayOfYear + 2) / 153
    val day = dayOfYear - (153 * month + 2) / 5 + 1
    val year = yearOfEra + era * 400 + if (month >= 10) 1 else 0
    val date = "$year-${two(if (month < 10) month + 3 else month - 9)}-${two(day)}"
    return "$date ${two(ofDay / 3600)}:${two(ofDay / 60 % 60)}:${two(ofDay % 60)} UTC"
}

/**
 * Returns time 0 of a log with the earliest time [firstMicros], both in µs. It is that time if it counts from 1970, as the clock of a
 * laptop does, otherwise 0. A clock that counts from the robot's start would need 31 years to reach such a time.
 */
public fun originOf(firstMicros: Double): Double = if (firstMicros in FIRST..LAST) firstMicros else 0.0

/**
 * Returns the ISO 8601 time in [text], in whole µs since 1970. Null if [text] is not such a time. It needs at least date, hour and minute.
 * With an offset, the result is in UTC, otherwise in the local time of the writer.
 */
internal fun microsOfIsoTime(text: String): Double? {
    // Most cells of a file are not times, and are excluded quickly.
    if (text.length < MIN_LENGTH || text[DASH] != '-') return null
    val match = ISO_TIME.matchEntire(text) ?: return null
    val (year, month, day, hour, minute, second) = match.destructured
    val days = daysTo(year.toInt(), month.toInt(), day.toInt()) ?: return null
    if (hour.toInt() > 23 || minute.toInt() > 59 || (second.isNotEmpty() && second.toInt() > 60)) return null
    val ofDay = hour.toInt() * 3600 + minute.toInt() * 60 + second.ifEmpty { "0" }.toInt()
    val fraction = match.groupValues[FRACTION].padEnd(6, '0').take(6)
    return (days * DAY + ofDay - offsetOf(match.groupValues[ZONE])) * 1e6 + fraction.toInt()
}

private fun offsetOf(zone: String): Int {
    if (zone.isEmpty() || zone[0] !in "+-") return 0
    val digits = zone.drop(1).replace(":", "")
    val seconds = digits.take(2).toInt() * 3600 + digits.drop(2).ifEmpty { "0" }.toInt() * 60
    return if (zone[0] == '-') -seconds else seconds
}

/** Returns the days from the start of 1970 to the date; null if there is no such date. */
public fun daysTo(year: Int, month: Int, day: Int): Long? {
    if (month !in 1..12 || day !in 1..MONTHS[month - 1]) return null
    val isLeapYear = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0)
    if (month == 2 && day == 29 && !isLeapYear) return null
    // Counting years from March puts the leap day at the end.
    val marchYear = if (month > 2) year else year - 1
    val dayOfYear = (153 * (if (month > 2) month - 3 else month + 9) + 2) / 5 + day - 1
    return marchYear * 365L + marchYear / 4 - marchYear / 100 + marchYear / 400 + dayOfYear - DAYS_TO_1970
}

private fun two(number: Int) = number.toString().padStart(2, '0')

private val ISO_TIME = Regex(
    "(\\d{4})-(\\d{2})-(\\d{2})[T ](\\d{2}):(\\d{2})(?::(\\d{2})(?:[.,](\\d{1,9}))?)? ?(Z|UTC|[+-]\\d{2}(?::?\\d{2})?)?",
)
private val MONTHS = listOf(31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31)
private const val MIN_LENGTH = "2024-03-16 10:41".length
private const val DASH = 4
private const val FRACTION = 7
private const val ZONE = 8

/** September 2001 and the end of 2096, in µs since 1970. */
private const val FIRST = 1e15
private const val LAST = 4e15
private const val DAY = 86400
private const val DAYS_TO_1970 = 719468
private const val DAYS_OF_ERA = 146097
private const val END_OF_9999 = 2.534023008e17
