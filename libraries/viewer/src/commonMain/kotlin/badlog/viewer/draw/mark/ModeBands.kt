package badlog.viewer.draw.mark

import badlog.core.analysis.Span
import kotlin.math.floor

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

    private companion object {
        const val FIRST_BANDS = 8
    }
}
