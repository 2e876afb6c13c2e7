package badlog.signals.match

import badlog.core.text.daysTo

/**
 * A date in a name.
 *
 * @property second the local time, in s since 1970 on the local clock; midnight if the name has no time of day.
 * @property range its place in the name.
 */
class NamedDate internal constructor(val second: Long, val range: IntRange)

/**
 * Returns the date in the name of a file, such as `FRC_20240910_002949.bag`. Null if there is none from 2000 to 2199; a clock that was not
 * set yet makes earlier ones.
 */
fun dateInName(name: String): NamedDate? {
    for ((pattern, century) in listOf(FOUR_DIGIT_YEAR to 0, TWO_DIGIT_YEAR to 2000)) {
        for (match in pattern.findAll(name)) {
            val (year, month, day, hour, minute, second) = match.destructured
            val time = secondOf(century + year.toInt(), month, day, hour, minute, second) ?: continue
            return NamedDate(time, match.range)
        }
    }
    return null
}

/**
 * Returns the local date in [text], in s since 1970 on the local clock; null if it has none. The text may be in ISO 8601, in RFC 1123, as
 * Java's `Date` prints it, month first with slashes, or in seconds or milliseconds since 1970.
 */
fun dateInText(text: String): Long? {
    val number = text.toDoubleOrNull()
    if (number != null && text.length >= SHORTEST_NUMBER) {
        val second = if (number > MILLISECONDS) number / 1000 else number
        return if (second in FIRST.toDouble()..LAST.toDouble()) believable(localSecondOf(second.toLong())) else null
    }
    writtenDate(text)?.let { date -> return believable(date.utcSecond?.let(::localSecondOf) ?: date.second) }
    return if (isWrittenDate(text)) null else dateInName(text)?.second
}

/** Returns the local time at [second], in s since 1970 in UTC. The result is in s since 1970 on the local clock. */
expect fun localSecondOf(second: Long): Long

private fun secondOf(year: Int, month: String, day: String, hour: String, minute: String, second: String): Long? {
    fun number(text: String) = if (text.isEmpty()) 0 else text.toInt()
    val (hours, minutes, seconds) = listOf(number(hour), number(minute), number(second))
    if (hours > 23 || minutes > 59 || seconds > 59) return null
    val days = daysTo(year, number(month), number(day)) ?: return null
    return believable(days * DAY + hours * HOUR + minutes * MINUTE + seconds)
}

// A robot's clock starts at about 1970 until something sets it.
private fun believable(second: Long): Long? = second.takeIf { it in FIRST..LAST }

private val FOUR_DIGIT_YEAR = Regex(
    "(?<!\\d)(\\d{4})[-_.]?(\\d{2})[-_.]?(\\d{2})(?:[T_ .-]{0,3}(\\d{2})[-_.:hH]?(\\d{2})(?:[-_.:mM]?(\\d{2}))?)?(?!\\d)",
)
private val TWO_DIGIT_YEAR = Regex("(?<!\\d)(\\d{2})-(\\d{2})-(\\d{2})[T_ -](\\d{2})[-_.:](\\d{2})(?:[-_.:](\\d{2}))?(?!\\d)")
private const val SHORTEST_NUMBER = 9

/** Above this, seconds would be in the year 5138. */
private const val MILLISECONDS = 1e11
private const val MINUTE = 60
private const val HOUR = 3600
private const val DAY = 86400L

/** The beginning of 2000 and the end of 2199. */
private const val FIRST = 946_684_800L
private const val LAST = 7_258_118_399L
