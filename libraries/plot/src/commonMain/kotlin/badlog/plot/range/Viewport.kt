package badlog.plot.range

import badlog.analysis.EnabledSpan
import badlog.analysis.Span
import kotlin.math.abs

/**
 * The part of the x axis that every graph shows, and those shown before. Never changes; each transition gives a new one.
 *
 * @property full all there is to see.
 * @property visible what is seen now; always within [full].
 * @property history what [back] returns to, the latest last.
 * @property ahead what [forward] returns to, the next one last.
 */
public data class Viewport(
    public val full: Span,
    public val visible: Span = full,
    private val history: List<Span> = emptyList(),
    private val ahead: List<Span> = emptyList(),
) {
    /** Whether there is more to see. */
    public val isZoomed: Boolean get() = visible != full

    /** Whether [back] leads somewhere. */
    public val canGoBack: Boolean get() = history.isNotEmpty()

    /** Whether [forward] leads somewhere. */
    public val canGoForward: Boolean get() = ahead.isNotEmpty()

    // Narrower, and neighboring pixels would be the same number.
    private val narrowest: Double
        get() = minOf(maxOf(full.width * 1e-9, maxOf(abs(full.from), abs(full.to)) * 1e-12, 1e-300), full.width)

    /** Shows what lies from [from] to [to], in any order, as one of many steps of a gesture: [back] passes it over. */
    public fun moved(from: Double, to: Double): Viewport {
        if (!from.isFinite() || !to.isFinite()) return this
        val width = abs(to - from).coerceIn(narrowest, full.width)
        val start = ((from + to) / 2 - width / 2).coerceIn(full.from, maxOf(full.from, full.to - width))
        return copy(visible = if (width >= full.width) full else Span(start, start + width))
    }

    /** Shows what lies from [from] to [to], in any order; [back] returns from it. */
    public fun showing(from: Double, to: Double): Viewport = remembered().moved(from, to)

    /** Shows a moment, or what lies from [from] to [to], and a little around it. */
    public fun around(from: Double, to: Double): Viewport = showing(from - full.width / AROUND, to + full.width / AROUND)

    /** Keeps what is seen now for [back]: how a gesture of many steps begins. */
    public fun remembered(): Viewport = copy(
        history = if (history.lastOrNull() == visible) history else (history + visible).takeLast(MAX_HISTORY),
        ahead = emptyList(),
    )

    /** Makes what is seen [factor] times as wide, leaving x = [center] where it stands on the screen, as one of many steps. */
    public fun scaled(factor: Double, center: Double): Viewport {
        val width = (visible.width * factor).coerceIn(narrowest, full.width)
        val share = (center - visible.from) / visible.width
        val start = (center - width * share).coerceIn(full.from, maxOf(full.from, full.to - width))
        return moved(start, start + width)
    }

    /** Zooms by [steps], in when positive, around the [cursor] where that is in sight, else around the middle. */
    public fun zoomed(steps: Int, cursor: Double?): Viewport {
        val center = if (cursor != null && cursor in visible) cursor else (visible.from + visible.to) / 2
        var zoomed = remembered()
        repeat(abs(steps)) { zoomed = zoomed.scaled(if (steps > 0) 1 / ZOOM else ZOOM, center) }
        return zoomed
    }

    /** Moves along by [distance] in x, backwards when negative, as one of many steps. */
    public fun shifted(distance: Double): Viewport = moved(visible.from + distance, visible.to + distance)

    /** Moves along by [share] of what is seen, backwards when negative. */
    public fun panned(share: Double): Viewport = remembered().shifted(visible.width * share)

    /** Shows everything. */
    public fun reset(): Viewport = if (isZoomed) remembered().copy(visible = full) else this

    /** Shows the time from the first of [enabled] to the last; nothing changes where that is unknown. */
    public fun showingEnabled(enabled: List<EnabledSpan>): Viewport {
        if (enabled.isEmpty()) return this
        val from = enabled.minOf { it.span.from }
        val to = enabled.maxOf { it.span.to }
        return if (to > from) showing(from, to) else this
    }

    /** Shows what was seen before. */
    public fun back(): Viewport {
        val before = history.dropLastWhile { it == visible }
        val last = before.lastOrNull() ?: return copy(history = before)
        return copy(visible = last, history = before.dropLast(1), ahead = ahead + visible)
    }

    /** Shows again what [back] led away from. */
    public fun forward(): Viewport {
        val next = ahead.lastOrNull() ?: return this
        return copy(visible = next, history = history + visible, ahead = ahead.dropLast(1))
    }

    /** Shows [x], moving no further than needed. */
    public fun revealing(x: Double): Viewport =
        if (x in visible || !x.isFinite()) this else showing(x - visible.width / 2, x + visible.width / 2)

    /** What is seen when the recording has grown to [grown]: its end follows when that was in sight. */
    public fun grown(grown: Span): Viewport = when {
        !isZoomed -> copy(full = grown, visible = grown)

        visible.to >= full.to -> copy(full = grown).moved(grown.to - visible.width, grown.to)

        // A program that begins its log anew makes it shorter.
        else -> copy(full = grown).moved(visible.from, visible.to)
    }

    public companion object {
        /** All of an axis that has samples in [range], null for none; wider than that where it is a single place. */
        public fun of(range: ClosedFloatingPointRange<Double>?): Viewport {
            if (range == null) return Viewport(Span(0.0, 1.0))
            val from = range.start
            val to = range.endInclusive
            val half = if (from < to) 0.0 else maxOf(0.5, abs(from) * 1e-6)
            return Viewport(Span(from - half, to + half))
        }

        private const val MAX_HISTORY = 100

        /** How much wider a step of zooming out makes what is visible. */
        private const val ZOOM = 1.5

        /** What is shown around a moment are two of so many parts. */
        private const val AROUND = 30
    }
}
