package badlog.files

import java.time.DateTimeException
import java.time.Instant
import java.time.LocalDateTime
import java.time.OffsetDateTime
import java.time.ZoneId

/**
 * A date in a name.
 *
 * @property time the date; at midnight if the name has no time of day.
 * @property range its place in the name.
 */
public class NamedDate internal constructor(public val time: LocalDateTime, public val range: IntRange)

private val FOUR_DIGIT_YEAR = Regex(
    "(?<!\\d)(\\d{4})[-_.]?(\\d{2})[-_.]?(\\d{2})(?:[T_ .-]{0,3}(\\d{2})[-_.:hH]?(\\d{2})(?:[-_.:mM]?(\\d{2}))?)?(?!\\d)",
)
private val TWO_DIGIT_YEAR = Regex("(?<!\\d)(\\d{2})-(\\d{2})-(\\d{2})[T_ -](\\d{2})[-_.:](\\d{2})(?:[-_.:](\\d{2}))?(?!\\d)")
private val MONTH_FIRST = Regex("(\\d{1,2})/(\\d{1,2})/(\\d{4})(?:[ ,T]+(\\d{1,2}):(\\d{2})(?::(\\d{2}))?)?.*")

/** Returns the date in the name of a file, such as `FRC_20240910_002949.bag`; null if there is none, or only that of a wrong clock. */
public fun dateInName(name: String): NamedDate? {
    for ((pattern, century) in listOf(FOUR_DIGIT_YEAR to 0, TWO_DIGIT_YEAR to 2000)) {
        for (match in pattern.findAll(name)) {
            val (year, month, day, hour, minute, second) = match.destructured
            val time = dateOf(century + year.toInt(), month, day, hour, minute, second) ?: continue
            return NamedDate(time, match.range)
        }
    }
    return null
}

/** Returns the date in [text]: as in ISO 8601, month first with slashes, or seconds or milliseconds since 1970; otherwise null. */
public fun dateInText(text: String): LocalDateTime? {
    val number = text.toDoubleOrNull()
    if (number != null && text.length >= 9) {
        // Above this, seconds would be in the year 5138.
        val millis = if (number > 1e11) number else number * 1000
        return believable(localTime(Instant.ofEpochMilli(millis.toLong())))
    }
    try {
        val standard = text.removeSuffix(" UTC").replace(' ', 'T') + if (text.endsWith(" UTC")) "Z" else ""
        return believable(localTime(OffsetDateTime.parse(standard).toInstant()))
    } catch (_: DateTimeException) {
        // Most have no offset.
    }
    MONTH_FIRST.matchEntire(text)?.let {
        val (month, day, year, hour, minute, second) = it.destructured
        return dateOf(year.toInt(), month, day, hour, minute, second)
    }
    return dateInName(text)?.time
}

private fun localTime(instant: Instant) = try {
    LocalDateTime.ofInstant(instant, ZoneId.systemDefault())
} catch (_: DateTimeException) {
    null
}

private fun dateOf(year: Int, month: String, day: String, hour: String, minute: String, second: String): LocalDateTime? = try {
    fun number(text: String) = if (text.isEmpty()) 0 else text.toInt()
    believable(LocalDateTime.of(year, number(month), number(day), number(hour), number(minute), number(second)))
} catch (_: DateTimeException) {
    null
}

// A robot's clock starts at about 1970 until something sets it.
private fun believable(time: LocalDateTime?) = time?.takeIf { it.year in 2000..2199 }
