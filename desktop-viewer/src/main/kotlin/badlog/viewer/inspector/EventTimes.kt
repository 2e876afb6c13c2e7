package badlog.viewer.inspector

import badlog.viewer.graph.text.decimalsFor
import badlog.viewer.graph.text.fixedText
import badlog.viewer.graph.text.minutesText
import badlog.viewer.recording.OpenRecording

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
    fun logged(x: Double): String = fixedText(x, decimals)

    /** `1:32.0` for 92 s after the robot was first enabled, negative before; null where nothing tells. */
    fun sinceEnabled(x: Double): String? {
        if (enabledFrom == null || perSecond == null || !x.isFinite()) return null
        return minutesText((x - enabledFrom) / perSecond)
    }
}
