package badlog.viewer.input

import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport

/** What a drag on the overview grabs. */
enum class OverviewGrip {
    /** The left edge of what is visible. */
    LEFT,

    /** Its right edge. */
    RIGHT,

    /** All of it. */
    WINDOW,

    /** Nothing: a new part is selected. */
    NEW,
    ;

    companion object {
        /** Returns what is at [x] on the overview of [viewport], whose pixels are [pixel] wide in x. */
        fun at(x: Double, viewport: Viewport, pixel: Double): OverviewGrip {
            val visible = viewport.visible
            val reach = EDGE * pixel
            // The middle of a narrow visible range can still be grabbed.
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
 * @property before the visible range at its start.
 * @param start where on x it began.
 * @param pixel the width in x of a CSS pixel or dp of the overview.
 */
class OverviewDrag(val before: Viewport, private val start: Double, private val pixel: Double) {
    /** What it has grabbed. */
    val grip: OverviewGrip = OverviewGrip.at(start, before, pixel)

    /** Whether it has moved far enough to be a drag rather than a click. */
    var hasMoved: Boolean = false
        private set

    /** Returns the visible range when the drag is at [x]. */
    fun movedTo(x: Double): Viewport {
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

    /** Returns the visible range after a click at [x]: a click outside the visible range moves it there. */
    fun clicked(x: Double): Viewport {
        val half = before.visible.width / 2
        return if (x in before.visible) before else before.showing(x - half, x + half)
    }

    private companion object {
        const val MIN_PIXELS = 3
    }
}
