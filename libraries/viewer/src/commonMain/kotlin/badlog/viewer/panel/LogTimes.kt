package badlog.viewer.panel

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Units
import badlog.core.analysis.XAxis
import badlog.viewer.text.decimalsFor
import badlog.viewer.text.fixedText
import badlog.viewer.text.minutesText

/**
 * Formats the times of a log of this [length], all with the same number of decimals. [axis] is the log's x axis, and [enabled] the time
 * when the robot was enabled.
 */
class LogTimes(length: Double, axis: XAxis, enabled: List<EnabledSpan>) {
    private val decimals = decimalsFor(length)
    private val enabledFrom = enabled.firstOrNull()?.span?.from
    private val seconds = Units.secondsIn(axis.unit)

    /** Returns [x] as it was logged; `–` if it is NaN. */
    fun logged(x: Double): String = fixedText(x, decimals)

    /** Returns the time at [x] since the robot was first enabled, such as `1:32.0` for 92 s; negative before, null if unknown. */
    fun sinceEnabled(x: Double): String? {
        if (enabledFrom == null || seconds == null || !x.isFinite()) return null
        return minutesText((x - enabledFrom) * seconds)
    }
}

/** The room for a panel. */
enum class PanelRoom {
    /** The panel has its own pane, which scrolls. */
    WHOLE,

    /** The panel is above graphs, which should stay visible. */
    SHARED,

    /** The panel is above graphs on a phone. */
    NARROW,

    /** The panel is printed, so nothing in it can be unfolded. */
    PAPER,
}
