package badlog.plot.timeline

import badlog.analysis.EnabledSpan
import badlog.analysis.LogView
import badlog.analysis.Series
import badlog.analysis.Span
import badlog.analysis.Units
import badlog.analysis.enabledSpans
import badlog.analysis.knowsAutonomous
import badlog.plot.text.minutesText
import kotlin.math.floor

/**
 * What an enabled robot does.
 *
 * @property title what front ends call it.
 */
public enum class RobotMode(public val title: String) {
    /** It is under its own control. */
    AUTONOMOUS("Auto"),

    /** A driver controls it. */
    TELEOP("Teleop"),

    /** One of the two; the log does not say which. */
    ENABLED("Enabled"),
}

/** A part of x over which the robot was in [mode]. */
public class ModeSpan(public val span: Span, public val mode: RobotMode)

/**
 * When the robot was in which mode, and the clock of the match.
 *
 * @property spans in the order of x, none over another.
 * @param secondsOfX how many seconds one x is; null where x is not a time.
 */
public class ModeTimeline(public val spans: List<ModeSpan>, private val secondsOfX: Double?) {
    private val starts = DoubleArray(spans.size) { spans[it].span.from }.let { Series(it, it) }
    private val ends = DoubleArray(spans.size) { spans[it].span.to }.let { Series(it, it) }

    /** For each span where its match begins: where the robot was enabled after it had been disabled for longer than [SAME_MATCH]. */
    private val matchStarts = DoubleArray(spans.size).also { matches ->
        for (i in spans.indices) {
            val goesOn = i > 0 && (spans[i].span.from - spans[i - 1].span.to) * (secondsOfX ?: 0.0) <= SAME_MATCH
            matches[i] = if (goesOn) matches[i - 1] else spans[i].span.from
        }
    }

    /** The index of the first span that reaches to [x] or beyond; their number when none does. */
    internal fun firstReaching(x: Double): Int = ends.firstAtOrAfter(x)

    /** The mode at [x]; null where the robot was disabled. */
    public fun modeAt(x: Double): RobotMode? = spans.getOrNull(starts.firstAfter(x) - 1)?.takeIf { x <= it.span.to }?.mode

    /**
     * The phase and the time since the robot was enabled at [x]: `Teleop 1:23`, and where it is disabled within a match, `Disabled 0:16`.
     * Null where the log does not say when it was enabled, and for an x that is not a time.
     */
    public fun clockAt(x: Double): String? {
        if (spans.isEmpty() || secondsOfX == null || !x.isFinite()) return null
        val index = starts.firstAfter(x) - 1
        val mode = modeAt(x)
        val goesOn = index >= 0 && index + 1 < spans.size && matchStarts[index + 1] == matchStarts[index]
        if (mode == null && !goesOn) return DISABLED
        val since = minutesText(floor((x - matchStarts[index]) * secondsOfX), 0)
        return "${mode?.title ?: DISABLED} $since"
    }

    public companion object {
        /** That of [view], by what its [modes][LogView.modes] are; empty where they are unknown. */
        public fun of(view: LogView): ModeTimeline {
            val knowsMode = view.knowsAutonomous
            val spans = view.enabledSpans().map { ModeSpan(it.span, modeOf(it, knowsMode)) }
            return ModeTimeline(spans, Units.secondsIn(view.xAxis.unit))
        }

        private fun modeOf(enabled: EnabledSpan, knowsMode: Boolean) = when {
            enabled.isAutonomous -> RobotMode.AUTONOMOUS
            knowsMode -> RobotMode.TELEOP
            else -> RobotMode.ENABLED
        }

        private const val DISABLED = "Disabled"

        /** Seconds for which a robot is disabled within a match, as while the link to it is lost. */
        private const val SAME_MATCH = 60.0
    }
}
