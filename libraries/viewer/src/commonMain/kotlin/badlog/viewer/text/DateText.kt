package badlog.viewer.text

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
