package badlog.viewer.draw.mark

import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import kotlin.math.floor

/** The clocks of a log besides its x axis: the match clock, see [ModeTimeline.clockAt], and the time of day. */
class Clocks(view: LogView, private val modes: ModeTimeline) {
    private val secondsOfX = Units.secondsIn(view.xAxis.unit)
    private val firstX = view.xAxis.range?.start ?: 0.0
    private val start = view.recording.values.firstOrNull { it.name == "Start Time" }?.let { TIME_OF_DAY.find(it.text) }

    /** Returns the phase and the time since the robot was enabled at [x]; null if unknown. */
    fun matchAt(x: Double): String? = modes.clockAt(x)

    /** Returns the local time of day at [x], at the place of recording: `14:03:22`. Null if the log does not say when it began. */
    fun dayAt(x: Double): String? {
        if (start == null || secondsOfX == null || !x.isFinite()) return null
        val (hours, minutes, seconds, fraction) = start.destructured
        val begin = (hours.toInt() * MINUTES + minutes.toInt()) * MINUTES + seconds.toInt() + (fraction.toDoubleOrNull() ?: 0.0)
        val passed = floor(begin + (x - firstX) * secondsOfX)
        if (!(passed >= 0 && passed < MAX_SECONDS)) return null
        val ofDay = passed.toInt() % DAY
        val parts = listOf(ofDay / (MINUTES * MINUTES), ofDay / MINUTES % MINUTES, ofDay % MINUTES)
        return parts.joinToString(":") { it.toString().padStart(2, '0') }
    }

    /** Returns the texts of both clocks: `Teleop 1:23 · 14:03:22`; empty if neither is known. */
    fun textAt(x: Double): String = listOfNotNull(matchAt(x), dayAt(x)).joinToString(" · ")

    private companion object {
        val TIME_OF_DAY = Regex("""[T ](\d\d):(\d\d):(\d\d)(\.\d{1,9})?""")
        const val MINUTES = 60
        const val DAY = 86_400
        const val MAX_SECONDS = 1e9
    }
}
