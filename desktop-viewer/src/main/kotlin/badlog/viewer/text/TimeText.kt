package badlog.viewer.text

import badlog.analysis.EnabledSpan
import badlog.analysis.Units
import badlog.analysis.XAxis
import badlog.recording.Topic
import kotlin.math.abs

/** [x] as a place on [axis], as exactly as a screen that shows [width] of it can tell, without the unit. */
internal fun placeText(x: Double, axis: XAxis, width: Double): String =
    // Between two rows there is nothing to see that decimals could tell.
    if (x.isNaN()) "–" else fixedText(x, if (axis.topic == null) 0 else decimalsFor(width).coerceAtMost(MOST_DECIMALS))

/** `1:33.7`, `1:02:05.0`: [seconds] in minutes, and hours where there are any. */
internal fun minutesText(seconds: Double, decimals: Int = 1): String {
    val text = fixedText(abs(seconds), decimals)
    val whole = text.substringBefore('.').toLongOrNull() ?: return text
    val rest = if ('.' in text) "." + text.substringAfter('.') else ""
    val sign = if (seconds < 0) "-" else ""
    val (hours, minutes) = whole / SECONDS / MINUTES to whole / SECONDS % MINUTES
    val large = if (hours > 0) "$hours:${twoDigits(minutes)}" else "$minutes"
    return "$sign$large:${twoDigits(whole % SECONDS)}$rest"
}

private fun twoDigits(number: Long) = number.toString().padStart(2, '0')

/** Where the cursor stands: `93.740 s · 1:31.7 since enabled`, the latter where [enabled] tells when that was. */
internal fun cursorText(x: Double, axis: XAxis, width: Double, enabled: List<EnabledSpan>): String {
    val place = withUnit(placeText(x, axis, width), axis.unit)
    val seconds = Units.secondsIn(axis.unit)
    if (seconds == null || !x.isFinite()) return place
    val start = enabled.firstOrNull()?.span?.from
    return when {
        start != null && x >= start -> "$place · ${minutesText((x - start) * seconds)} since enabled"
        abs(x * seconds) >= SECONDS -> "$place · ${minutesText(x * seconds)}"
        else -> place
    }
}

/** A length on [axis], with a unit. */
internal fun lengthText(length: Double, axis: XAxis): String {
    val number = withUnit(exactText(fixedText(length, decimalsFor(length).coerceAtMost(MOST_DECIMALS)).toDouble()), axis.unit)
    val name = if (axis.unit == Topic.UNITLESS && axis.topic == null) "$number rows" else number
    val seconds = Units.secondsIn(axis.unit)?.let { length * it } ?: 0.0
    return if (seconds >= SECONDS) "$name · ${minutesText(seconds)}" else name
}

private const val SECONDS = 60
private const val MINUTES = 60
private const val MOST_DECIMALS = 6
