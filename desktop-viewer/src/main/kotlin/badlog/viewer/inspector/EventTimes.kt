package badlog.viewer.inspector

import badlog.analysis.Units
import badlog.viewer.recording.OpenRecording
import badlog.viewer.text.decimalsFor
import badlog.viewer.text.fixedText
import badlog.viewer.text.minutesText

/** Writes the times of a recording's events: as they were logged, and in minutes since the robot was enabled. */
internal class EventTimes(recording: OpenRecording) {
    private val decimals = decimalsFor(recording.span.width)
    private val enabledFrom = recording.enabled.firstOrNull()?.span?.from
    private val seconds = Units.secondsIn(recording.view.xAxis.unit)

    /** [x] as it was logged, all with as many decimals; `–` for none. */
    fun logged(x: Double): String = fixedText(x, decimals)

    /** `1:32.0` for 92 s after the robot was first enabled, negative before; null where nothing tells. */
    fun sinceEnabled(x: Double): String? {
        if (enabledFrom == null || seconds == null || !x.isFinite()) return null
        return minutesText((x - enabledFrom) * seconds)
    }
}
