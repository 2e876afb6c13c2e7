package badlog.viewer.graph.text

import badlog.analysis.EnabledSpan
import badlog.analysis.XAxis
import badlog.recording.Topic
import kotlin.math.abs

/** Whether x is counted in seconds, so that minutes say more than a large number. */
internal val XAxis.isInSeconds: Boolean get() = unit == "s" || unit == "sec" || unit == "seconds"

/** [x] as a place on [axis], as exactly as a screen that shows [width] of it can tell, without the unit. */
internal fun placeText(x: Double, axis: XAxis, width: Double): String =
    // Between two rows there is nothing to see that decimals could tell.
    if (x.isNaN()) "–" else fixedText(x, if (axis.topic == null) 0 else decimalsFor(width).coerceAtMost(MOST_DECIMALS))

/** `1:33.7`: [seconds] in minutes. */
internal fun minutesText(seconds: Double, decimals: Int = 1): String {
    val text = fixedText(abs(seconds), decimals)
    val whole = text.substringBefore('.').toLongOrNull() ?: return text
    val rest = if ('.' in text) "." + text.substringAfter('.') else ""
    val sign = if (seconds < 0) "-" else ""
    return "$sign${whole / SECONDS}:${(whole % SECONDS).toString().padStart(2, '0')}$rest"
}

/** Where the cursor stands: `93.740 s · 1:32.7 of the match`, the latter where [enabled] tells when that began. */
internal fun cursorText(x: Double, axis: XAxis, width: Double, enabled: List<EnabledSpan>): String {
    val place = withUnit(placeText(x, axis, width), axis.unit)
    if (!axis.isInSeconds || !x.isFinite()) return place
    val start = enabled.firstOrNull()?.span?.from
    return when {
        start != null && x >= start -> "$place · ${minutesText(x - start)} since enabled"
        abs(x) >= SECONDS -> "$place · ${minutesText(x)}"
        else -> place
    }
}

/** A length on [axis], with a unit. */
internal fun lengthText(length: Double, axis: XAxis): String {
    val number = withUnit(numberText(fixedText(length, decimalsFor(length).coerceAtMost(MOST_DECIMALS)).toDouble()), axis.unit)
    val name = if (axis.unit == Topic.UNITLESS && axis.topic == null) "$number rows" else number
    return if (axis.isInSeconds && length >= SECONDS) "$name · ${minutesText(length)}" else name
}

private const val SECONDS = 60
private const val MOST_DECIMALS = 6
