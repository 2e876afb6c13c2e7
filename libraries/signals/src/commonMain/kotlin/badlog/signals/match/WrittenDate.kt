package badlog.signals.match

import badlog.core.text.daysTo

/**
 * A date that a program wrote as a text.
 *
 * @property second the local time at the place of writing, in s since 1970 on the local clock.
 * @property offset the seconds by which that clock is ahead of UTC; null if the text does not say.
 */
internal class WrittenDate(val second: Long, val offset: Int?) {
    /** The same moment in UTC, in s since 1970; null if it is not known. */
    val utcSecond: Long? get() = offset?.let { second - it }
}

/**
 * Returns the date in [text]; null if it is not in one of these forms. English names of months occur as in RFC 1123
 * (`Fri, 16 Mar 2018 10:41:07 -0400`), in Java's `Date` (`Fri Mar 16 10:41:07 EDT 2018`) or for people in the United States
 * (`Mar 16, 2018, 2:41:07 PM`). Others are in ISO 8601, or with slashes, month first.
 */
internal fun writtenDate(text: String): WrittenDate? {
    for ((pattern, order) in PATTERNS) {
        val match = pattern.matchEntire(text.trim()) ?: continue
        val part = { name: Char -> order.indexOf(name).let { if (it < 0) "" else match.groupValues[it + 1] } }
        val month = monthOf(part('M')) ?: return null
        val days = daysTo(part('y').toInt(), month, part('d').toInt()) ?: return null
        val hour = hourOf(part('h'), part('a')) ?: return null
        val (minute, second) = listOf(part('m'), part('s')).map { if (it.isEmpty()) 0 else it.toInt() }
        if (minute > 59 || second > 59) return null
        val zone = part('z')
        val offset = if (zone.isEmpty()) null else offsetOf(zone)
        if (offset == null && zone.any { it in "+-" }) return null
        return WrittenDate(days * DAY + hour * HOUR + minute * MINUTE + second, offset)
    }
    return null
}

/** Returns whether [text] has the form of a date of [writtenDate], even if there is no such date. */
internal fun isWrittenDate(text: String): Boolean = PATTERNS.any { (pattern, _) -> pattern.matches(text.trim()) }

private fun monthOf(text: String): Int? = text.toIntOrNull()
    ?: (MONTHS.indexOf(text.take(3).lowercase()) + 1).takeIf { it > 0 && FULL_MONTHS[it - 1].startsWith(text.lowercase()) }

private fun hourOf(text: String, half: String): Int? {
    val hour = if (text.isEmpty()) 0 else text.toInt()
    return when {
        half.isEmpty() -> hour.takeIf { it <= 23 }
        hour !in 1..12 -> null
        half.startsWith("a", ignoreCase = true) -> hour % 12
        else -> hour % 12 + 12
    }
}

/** Returns the seconds by which a clock in [zone] is ahead of UTC. Null if the zone is unknown, or its short name has several meanings. */
private fun offsetOf(zone: String): Int? {
    ZONES[zone.uppercase()]?.let { return it * HOUR }
    val match = OFFSET.matchEntire(zone) ?: return null
    val (sign, hours, minutes, seconds) = match.destructured
    fun number(digits: String) = if (digits.isEmpty()) 0 else digits.toInt()
    val offset = number(hours) * HOUR + number(minutes) * MINUTE + number(seconds)
    return if (offset > FARTHEST) {
        null
    } else if (sign == "-") {
        -offset
    } else {
        offset
    }
}

private const val WEEKDAY = "(?:[A-Za-z]{3,9},? +)?"
private const val CLOCK = "(\\d{1,2}):(\\d{2})(?::(\\d{2})(?:[.,]\\d+)?)?"

// Newer versions of Java put a narrow space without a break before AM and PM.
private const val HALF = "(?:[ \u00A0\u202F]?([AaPp]\\.?[Mm]\\.?))?"

// JavaScript needs the closing bracket escaped.
private const val ZONE = "(?: ?([A-Za-z]{1,5}|(?:GMT|UTC|UT)?[+-]\\d{1,2}(?::?\\d{2}(?::?\\d{2})?)?)(?:\\[[A-Za-z0-9_/+-]+\\])?)?"

/** Each form with the meaning of its groups: year, month, day, hour, minute, second, a.m. or p.m., and zone. */
private val PATTERNS = listOf(
    Regex("$WEEKDAY(\\d{1,2})[ -]([A-Za-z]{3,9})[ -](\\d{4})(?:[ ,]+$CLOCK$HALF$ZONE)?") to "dMyhmsaz",
    Regex("$WEEKDAY([A-Za-z]{3,9}) +(\\d{1,2}) $CLOCK$ZONE (\\d{4})") to "Mdhmszy",
    Regex("$WEEKDAY([A-Za-z]{3,9}) (\\d{1,2}), (\\d{4})(?:(?:,| at)? $CLOCK$HALF$ZONE)?") to "Mdyhmsaz",
    Regex("(\\d{4})-(\\d{2})-(\\d{2})[T ]$CLOCK$ZONE") to "yMdhmsz",
    Regex("(\\d{1,2})/(\\d{1,2})/(\\d{4})(?:[ ,T]+$CLOCK$HALF$ZONE)?") to "Mdyhmsaz",
)
private val OFFSET = Regex("(?:GMT|UTC|UT)?([+-])(\\d{1,2})(?::?(\\d{2}))?(?::?(\\d{2}))?")

/**
 * The offsets of zones in hours, by their short names. A name means one offset only, or nearly always the one in RFC 1123. CST is left out: it is
 * also the time of China and Taiwan.
 */
private val ZONES = mapOf(
    "Z" to 0, "UT" to 0, "UTC" to 0, "GMT" to 0,
    "EST" to -5, "EDT" to -4, "CDT" to -5, "MST" to -7, "MDT" to -6, "PST" to -8, "PDT" to -7,
    "AKST" to -9, "AKDT" to -8, "HST" to -10, "CET" to 1, "CEST" to 2, "EET" to 2, "EEST" to 3,
)
private val FULL_MONTHS = listOf(
    "january", "february", "march", "april", "may", "june", "july", "august", "september", "october", "november", "december",
)
private val MONTHS = FULL_MONTHS.map { it.take(3) }
private const val MINUTE = 60
private const val HOUR = 3600
private const val DAY = 86400L
private const val FARTHEST = 18 * HOUR
