package badlog.plot.gesture

import badlog.analysis.Span
import badlog.plot.range.Viewport

/** What a drag on the overview takes hold of. */
public enum class OverviewGrip {
    /** The left edge of what is visible. */
    LEFT,

    /** Its right edge. */
    RIGHT,

    /** All of it. */
    WINDOW,

    /** Nothing: a new part is chosen. */
    NEW,
    ;

    public companion object {
        /** What is at [x] of the overview of [viewport], a pixel of which is [pixel] wide in x. */
        public fun at(x: Double, viewport: Viewport, pixel: Double): OverviewGrip {
            val visible = viewport.visible
            val reach = EDGE * pixel
            // Of a narrow window the middle can still be taken.
            val inside = minOf(reach, visible.width / 4)
            return when {
                !viewport.isZoomed -> NEW
                x in visible.from - reach..visible.from + inside -> LEFT
                x in visible.to - inside..visible.to + reach -> RIGHT
                x in visible -> WINDOW
                else -> NEW
            }
        }

        private const val EDGE = 6
    }
}

/**
 * A drag on the overview.
 *
 * @property before what was seen at its start.
 * @param start where on x it began.
 * @param pixel how much of x a CSS pixel or dp of the overview is.
 */
public class OverviewDrag(public val before: Viewport, private val start: Double, private val pixel: Double) {
    /** What it has taken hold of. */
    public val grip: OverviewGrip = OverviewGrip.at(start, before, pixel)

    /** Whether it has gone far enough to be one, rather than a click. */
    public var hasMoved: Boolean = false
        private set

    /** What is seen when it is at [x]. */
    public fun movedTo(x: Double): Viewport {
        if (!hasMoved && x - start < MIN_PIXELS * pixel && start - x < MIN_PIXELS * pixel) return before
        hasMoved = true
        val seen: Span = before.visible
        return with(before.remembered()) {
            when (grip) {
                OverviewGrip.LEFT -> moved(minOf(x, seen.to), seen.to)
                OverviewGrip.RIGHT -> moved(seen.from, maxOf(x, seen.from))
                OverviewGrip.WINDOW -> moved(seen.from + x - start, seen.to + x - start)
                OverviewGrip.NEW -> moved(start, x)
            }
        }
    }

    /** What is seen after a click at [x]: beside what was visible, it brings that there. */
    public fun clicked(x: Double): Viewport {
        val half = before.visible.width / 2
        return if (x in before.visible) before else before.showing(x - half, x + half)
    }

    private companion object {
        const val MIN_PIXELS = 3
    }
}
