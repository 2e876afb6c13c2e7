package badlog.viewer.panel

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Units
import badlog.core.analysis.XAxis
import badlog.viewer.text.decimalsFor
import badlog.viewer.text.fixedText
import badlog.viewer.text.minutesText

/**
 * Formats times of a log that has a [length], all with the same number of decimals. [axis] is the log's x, and the robot was [enabled]
 * then.
 */
class LogTimes(length: Double, axis: XAxis, enabled: List<EnabledSpan>) {
    private val decimals = decimalsFor(length)
    private val enabledFrom = enabled.firstOrNull()?.span?.from
    private val seconds = Units.secondsIn(axis.unit)

    /** Returns [x] as it was logged; `–` if it is NaN. */
    fun logged(x: Double): String = fixedText(x, decimals)

    /** Returns `1:32.0` for 92 s after the robot was first enabled, negative before; null if unknown. */
    fun sinceEnabled(x: Double): String? {
        if (enabledFrom == null || seconds == null || !x.isFinite()) return null
        return minutesText((x - enabledFrom) * seconds)
    }
}
