package badlog.viewer.view

import badlog.analysis.Span
import kotlin.math.abs

/**
 * The part of the x axis that every graph shows, and those shown before. Never changes; each transition gives a new one.
 *
 * @property full all there is to see.
 * @property visible what is seen now; always within [full].
 * @property history what [back] returns to, the latest last.
 */
internal data class Viewport(val full: Span, val visible: Span = full, val history: List<Span> = emptyList()) {
    val isZoomed: Boolean get() = visible != full

    // Narrower, and neighbouring pixels would be the same number.
    private val narrowest: Double
        get() = minOf(maxOf(full.width * 1e-9, maxOf(abs(full.from), abs(full.to)) * 1e-12, 1e-300), full.width)

    /** Shows what lies from [from] to [to], in any order, as one of many steps of a gesture: [back] passes it over. */
    fun moved(from: Double, to: Double): Viewport {
        if (!from.isFinite() || !to.isFinite()) return this
        val width = abs(to - from).coerceIn(narrowest, full.width)
        val start = ((from + to) / 2 - width / 2).coerceIn(full.from, maxOf(full.from, full.to - width))
        return copy(visible = if (width >= full.width) full else Span(start, start + width))
    }

    /** Shows what lies from [from] to [to], in any order; [back] returns from it. */
    fun showing(from: Double, to: Double): Viewport = remembered().moved(from, to)

    /** Keeps what is seen now for [back]: how a gesture of many steps begins. */
    fun remembered(): Viewport =
        if (history.lastOrNull() == visible) this else copy(history = (history + visible).takeLast(LONGEST_HISTORY))

    /** Makes what is seen [factor] times as wide, leaving x = [center] where it stands on the screen. */
    fun scaled(factor: Double, center: Double): Viewport {
        val width = (visible.width * factor).coerceIn(narrowest, full.width)
        val share = (center - visible.from) / visible.width
        val start = (center - width * share).coerceIn(full.from, maxOf(full.from, full.to - width))
        return moved(start, start + width)
    }

    /** Moves along by [distance] in x, backwards when negative. */
    fun shifted(distance: Double): Viewport = moved(visible.from + distance, visible.to + distance)

    /** Shows everything. */
    fun reset(): Viewport = if (isZoomed) remembered().copy(visible = full) else this

    /** Shows what was seen before. */
    fun back(): Viewport {
        val before = history.dropLastWhile { it == visible }
        return if (before.isEmpty()) copy(history = before) else copy(visible = before.last(), history = before.dropLast(1))
    }

    /** Shows [x], moving no further than needed. */
    fun revealing(x: Double): Viewport = if (x in visible || !x.isFinite()) this else showing(x - visible.width / 2, x + visible.width / 2)

    /** What is seen when the recording has grown to [grown]: its end follows when that was in sight. */
    fun grown(grown: Span): Viewport = when {
        !isZoomed -> copy(full = grown, visible = grown)

        visible.to >= full.to -> copy(full = grown).moved(grown.to - visible.width, grown.to)

        // A program that begins its log anew makes it shorter.
        else -> copy(full = grown).moved(visible.from, visible.to)
    }

    companion object {
        private const val LONGEST_HISTORY = 100
    }
}
