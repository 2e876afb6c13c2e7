package badlog.viewer.inspector

import badlog.viewer.recording.OpenRecording
import java.util.Locale
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log10

/** Writes the times of a recording's events: as they were logged, and in minutes since the robot was enabled. */
internal class EventTimes(recording: OpenRecording) {
    private val decimals = decimalsFor(recording.span.width)
    private val enabledFrom = recording.enabled.firstOrNull()?.span?.from
    private val perSecond = when (recording.view.xAxis.unit.trim().lowercase()) {
        "s", "sec", "secs", "second", "seconds" -> 1.0
        "ms" -> 1e3
        "us", "µs" -> 1e6
        else -> null
    }

    /** [x] as it was logged, all with as many decimals; `–` for none. */
    fun logged(x: Double): String = if (x.isFinite()) "%.${decimals}f".format(Locale.ROOT, x) else "–"

    /** `1:32` for 92 s after the robot was first enabled, negative before; null where nothing tells. */
    fun sinceEnabled(x: Double): String? {
        if (enabledFrom == null || perSecond == null || !x.isFinite()) return null
        val seconds = floor((x - enabledFrom) / perSecond)
        if (abs(seconds) >= LONGEST) return null
        val whole = abs(seconds).toLong()
        return "${if (seconds < 0) "-" else ""}${whole / 60}:${(whole % 60).toString().padStart(2, '0')}"
    }

    private companion object {
        const val LONGEST = 1e9

        /** How many decimals tell events apart on an axis of which [width] is there. */
        fun decimalsFor(width: Double): Int = ceil(4 - log10(width)).toInt().coerceIn(0, 9)
    }
}
