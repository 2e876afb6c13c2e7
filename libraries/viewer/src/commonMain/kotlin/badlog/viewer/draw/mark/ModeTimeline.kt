package badlog.viewer.draw.mark

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.FlagReading
import badlog.core.analysis.FlagTopic
import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.Units
import badlog.core.analysis.enabledSpans
import badlog.core.analysis.knowsAutonomous
import badlog.viewer.text.minutesText
import kotlin.math.floor

/**
 * The mode of an enabled robot.
 *
 * @property title the name in front ends.
 */
enum class RobotMode(val title: String) {
    /** The robot controls itself. */
    AUTONOMOUS("Auto"),

    /** A driver controls the robot. */
    TELEOP("Teleop"),

    /** The robot is being tested, in seasons until 2026. */
    TEST("Test"),

    /** The robot is being tested, in seasons from 2027 on. */
    UTILITY("Utility"),

    /** The robot is in one of these modes; the log does not say which. */
    ENABLED("Enabled"),
}

/** A part of x over which the robot was in [mode], and ran the op mode [opMode]; that is null if there was none. */
class ModeSpan(val span: Span, val mode: RobotMode, private val opMode: String? = null) {
    /** The name of the phase: `Teleop`, or with an op mode `Auto (Two pieces)`. */
    internal val title: String get() = if (opMode == null) mode.title else "${mode.title} ($opMode)"
}

/**
 * The modes of the robot over time, and the match clock.
 *
 * @property spans the spans in the order of x, without overlaps.
 * @param secondsOfX the number of seconds in one unit of x; null if x is not a time.
 */
class ModeTimeline(val spans: List<ModeSpan>, private val secondsOfX: Double?) {
    private val starts = DoubleArray(spans.size) { spans[it].span.from }.let { Series(it, it) }
    private val ends = DoubleArray(spans.size) { spans[it].span.to }.let { Series(it, it) }

    /** The start of each span's match: the robot was enabled after being disabled for longer than [SAME_MATCH]. */
    private val matchStarts = DoubleArray(spans.size).also { matches ->
        for (i in spans.indices) {
            val goesOn = i > 0 && (spans[i].span.from - spans[i - 1].span.to) * (secondsOfX ?: 0.0) <= SAME_MATCH
            matches[i] = if (goesOn) matches[i - 1] else spans[i].span.from
        }
    }

    /** Returns the index of the first span that reaches [x]; the number of spans if none does. */
    internal fun firstReaching(x: Double): Int = ends.firstAtOrAfter(x)

    /** Returns the mode at [x]; null if the robot was disabled. */
    fun modeAt(x: Double): RobotMode? = spanAt(x)?.mode

    private fun spanAt(x: Double) = spans.getOrNull(starts.firstAfter(x) - 1)?.takeIf { x <= it.span.to }

    /**
     * Returns the phase and the time since the robot was enabled at [x]. Examples: `Teleop 1:23`, `Auto (Two pieces) 0:12`; `Disabled 0:16`
     * while it is disabled within a match. Null if the log does not say when it was enabled, or if x is not a time.
     */
    fun clockAt(x: Double): String? {
        if (spans.isEmpty() || secondsOfX == null || !x.isFinite()) return null
        val index = starts.firstAfter(x) - 1
        val phase = spanAt(x)
        val goesOn = index >= 0 && index + 1 < spans.size && matchStarts[index + 1] == matchStarts[index]
        if (phase == null && !goesOn) return DISABLED
        val since = minutesText(floor((x - matchStarts[index]) * secondsOfX), 0)
        return "${phase?.title ?: DISABLED} $since"
    }

    companion object {
        /** Returns the timeline of [view], according to its [modes][LogView.modes]; empty if they are unknown. */
        fun of(view: LogView): ModeTimeline {
            val knowsMode = view.knowsAutonomous
            val test = if (isOf2027(view.modes.test)) RobotMode.UTILITY else RobotMode.TEST
            val spans = view.enabledSpans().map { ModeSpan(it.span, if (it.isTest) test else modeOf(it, knowsMode), it.opMode) }
            return ModeTimeline(spans, Units.secondsIn(view.xAxis.unit))
        }

        /** Returns whether [test] is one of several modes in a topic; until 2026, it was a flag. */
        private fun isOf2027(test: FlagTopic?) =
            test?.reading.let { it is FlagReading.Text || (it is FlagReading.Bits && it.last > it.first) }

        private fun modeOf(enabled: EnabledSpan, knowsMode: Boolean) = when {
            enabled.isAutonomous -> RobotMode.AUTONOMOUS
            knowsMode -> RobotMode.TELEOP
            else -> RobotMode.ENABLED
        }

        private const val DISABLED = "Disabled"

        /** The maximum time in s between two parts of a match, for example while the link is lost. */
        private const val SAME_MATCH = 60.0
    }
}

/** The bands that shade the time when the robot was enabled, from left to right. The arrays are reused for the next drawing. */
class ModeBands {
    private var left = DoubleArray(FIRST_BANDS)
    private var right = DoubleArray(FIRST_BANDS)
    private var modes = IntArray(FIRST_BANDS)

    var size: Int = 0
        private set

    /** Returns the start of band [index], in pixels from the left. */
    fun leftOf(index: Int): Double = left[index]

    fun rightOf(index: Int): Double = right[index]

    fun modeOf(index: Int): RobotMode = RobotMode.entries[modes[index]]

    /**
     * Finds the bands of [timeline] in [span], over [width] pixels. The cost is limited by the number of pixels, however often the robot
     * was enabled. Bands shorter than a pixel get one pixel.
     */
    fun place(timeline: ModeTimeline, span: Span, width: Double) {
        size = 0
        if (!(span.width > 0) || !(width >= 1)) return
        var index = timeline.firstReaching(span.from)
        while (index < timeline.spans.size && timeline.spans[index].span.from <= span.to) {
            val one = timeline.spans[index]
            val from = ((one.span.from - span.from) / span.width * width).coerceIn(0.0, width - 1)
            val to = ((one.span.to - span.from) / span.width * width).coerceIn(from + 1, width)
            add(from, to, one.mode)
            index++
            // Other spans that end in the same pixel would be invisible.
            if (to <= from + 1) index = maxOf(index, timeline.firstReaching(span.from + (floor(from) + 1) * span.width / width))
        }
    }

    private fun add(from: Double, to: Double, mode: RobotMode) {
        val last = size - 1
        // A band that touches the previous one extends it if the mode is the same. Otherwise it begins at its end.
        if (last >= 0 && modes[last] == mode.ordinal && from - right[last] < 1) {
            right[last] = maxOf(right[last], to)
            return
        }
        val start = if (last >= 0) maxOf(from, right[last]) else from
        if (start >= to) return
        if (size == left.size) {
            left = left.copyOf(size * 2)
            right = right.copyOf(size * 2)
            modes = modes.copyOf(size * 2)
        }
        left[size] = start
        right[size] = to
        modes[size++] = mode.ordinal
    }
}

private const val FIRST_BANDS = 8
