package badlog.formats.column

import kotlin.math.floor

/** Returns the moment [micros] µs after the start of 1970, in UTC: `2024-03-09 14:02:31 UTC`. Null outside the years 1970 to 9999. */
internal fun wallTimeText(micros: Double): String? {
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

private fun two(number: Int) = number.toString().padStart(2, '0')

private const val DAY = 86400
private const val DAYS_TO_1970 = 719468
private const val DAYS_OF_ERA = 146097
private const val END_OF_9999 = 2.534023008e17
