package badlog.viewer.choices.range

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Span
import badlog.core.analysis.StateRuns
import kotlin.math.abs

/**
 * The part of the x axis that every graph shows, with its history. Immutable; each transition returns a new one.
 *
 * @property full the whole range.
 * @property visible the visible range; always within [full].
 * @property history the ranges that [back] returns to, the latest last.
 * @property ahead the ranges that [forward] returns to, the next one last.
 */
data class Viewport(
    val full: Span,
    val visible: Span = full,
    private val history: List<Span> = emptyList(),
    private val ahead: List<Span> = emptyList(),
) {
    /** Whether only a part of the whole range is visible. */
    val isZoomed: Boolean get() = visible != full

    /** Whether the end of the whole range is visible, except for a rounding error. */
    val isAtEnd: Boolean get() = full.to - visible.to <= visible.width * ROUNDING

    /** Whether [back] has an effect. */
    val canGoBack: Boolean get() = history.isNotEmpty()

    /** Whether [forward] has an effect. */
    val canGoForward: Boolean get() = ahead.isNotEmpty()

    // In a narrower range, neighboring pixels would be the same number.
    private val narrowest: Double
        get() = minOf(maxOf(full.width * 1e-9, maxOf(abs(full.from), abs(full.to)) * 1e-12, 1e-300), full.width)

    /** Shows the range from [from] to [to], in any order, as one of many steps of a gesture. [back] skips them. */
    internal fun moved(from: Double, to: Double): Viewport {
        if (!from.isFinite() || !to.isFinite()) return this
        val width = abs(to - from).coerceIn(narrowest, full.width)
        val start = ((from + to) / 2 - width / 2).coerceIn(full.from, maxOf(full.from, full.to - width))
        return copy(visible = if (width >= full.width) full else Span(start, start + width))
    }

    /** Shows the range from [from] to [to], in any order; [back] returns from it. */
    internal fun showing(from: Double, to: Double): Viewport = remembered().moved(from, to)

    /** Shows a moment, or the range from [from] to [to], with some margin. */
    internal fun around(from: Double, to: Double): Viewport = showing(from - full.width / AROUND, to + full.width / AROUND)

    /** Remembers the visible range for [back], at the start of a gesture of many steps. */
    internal fun remembered(): Viewport = copy(
        history = if (history.lastOrNull() == visible) history else (history + visible).takeLast(MAX_HISTORY),
        ahead = emptyList(),
    )

    /** Makes the visible range [factor] times as wide, as one of many steps. [center] stays at its place on the screen. */
    internal fun scaled(factor: Double, center: Double): Viewport {
        val width = (visible.width * factor).coerceIn(narrowest, full.width)
        val share = (center - visible.from) / visible.width
        val start = (center - width * share).coerceIn(full.from, maxOf(full.from, full.to - width))
        return moved(start, start + width)
    }

    /** Zooms in by [steps], or out if negative: around the [cursor] if it is visible, otherwise around the middle. */
    internal fun zoomed(steps: Int, cursor: Double?): Viewport {
        val center = if (cursor != null && cursor in visible) cursor else (visible.from + visible.to) / 2
        var zoomed = remembered()
        repeat(abs(steps)) { zoomed = zoomed.scaled(if (steps > 0) 1 / ZOOM else ZOOM, center) }
        return zoomed
    }

    /** Moves by [distance] in x, backwards if negative, as one of many steps. */
    internal fun shifted(distance: Double): Viewport = moved(visible.from + distance, visible.to + distance)

    /** Moves by [share] of the visible range, backwards if negative. */
    internal fun panned(share: Double): Viewport = remembered().shifted(visible.width * share)

    /** Shows the whole range. */
    internal fun reset(): Viewport = if (isZoomed) remembered().copy(visible = full) else this

    /** Shows the time from the first to the last of [enabled]; nothing changes if that is empty. */
    internal fun showingEnabled(enabled: List<EnabledSpan>): Viewport {
        if (enabled.isEmpty()) return this
        val from = enabled.minOf { it.span.from }
        val to = enabled.maxOf { it.span.to }
        return if (to > from) showing(from, to) else this
    }

    /** Shows the previous range. */
    internal fun back(): Viewport {
        val before = history.dropLastWhile { it == visible }
        val last = before.lastOrNull() ?: return copy(history = before)
        return copy(visible = last, history = before.dropLast(1), ahead = ahead + visible)
    }

    /** Shows the range that [back] left. */
    internal fun forward(): Viewport {
        val next = ahead.lastOrNull() ?: return this
        return copy(visible = next, history = history + visible, ahead = ahead.dropLast(1))
    }

    /** Makes [x] visible, in the middle unless it already is visible. */
    internal fun revealing(x: Double): Viewport = if (x in visible ||
        !x.isFinite()
    ) {
        this
    } else {
        showing(x - visible.width / 2, x + visible.width / 2)
    }

    /** Returns the viewport after the recording has grown to [grown]. It follows the end if the end was visible. */
    internal fun grown(grown: Span): Viewport = when {
        !isZoomed -> copy(full = grown, visible = grown)

        isAtEnd -> copy(full = grown).moved(grown.to - visible.width, grown.to)

        // A program that restarts its log makes it shorter.
        else -> copy(full = grown).moved(visible.from, visible.to)
    }

    companion object {
        /**
         * Returns the viewport that shows all of an axis with samples in [range]; 0 to 1 if that is null. A range of a single place is
         * widened.
         */
        fun of(range: ClosedFloatingPointRange<Double>?): Viewport {
            if (range == null) return Viewport(Span(0.0, 1.0))
            val from = range.start
            val to = range.endInclusive
            val half = if (from < to) 0.0 else maxOf(0.5, abs(from) * 1e-6)
            return Viewport(Span(from - half, to + half))
        }

        private const val ROUNDING = 1e-9
        private const val MAX_HISTORY = 100

        /** The factor by which a step of zooming out widens the visible range. */
        private const val ZOOM = 1.5

        /** The quotient of the whole range and the margin on either side of a moment. */
        private const val AROUND = 30
    }
}

/** The range of x in which this line's recording has samples; a single x is widened, see [Viewport.of]. */
val GraphSeries.wholeRange: Span get() = Viewport.of(recorded).full

/** The x until which the last value of this line holds: the end of its recording. Null if its samples are joined by straight lines. */
val GraphSeries.holdsUntil: Double? get() = if (holds) wholeRange.to else null

/** Returns the runs of this line's states; the last one lasts until the end of its recording. */
fun GraphSeries.stateRuns(): StateRuns = StateRuns(data, wholeRange.to)
