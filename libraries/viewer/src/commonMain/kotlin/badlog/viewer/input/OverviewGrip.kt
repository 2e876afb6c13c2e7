package badlog.viewer.input

import badlog.viewer.choices.range.Viewport

/** The part of the overview that a drag grabs. */
enum class OverviewGrip {
    /** The left edge of the visible range. */
    LEFT,

    /** The right edge of the visible range. */
    RIGHT,

    /** The whole visible range. */
    WINDOW,

    /** None of them: the drag selects a new range. */
    NEW,
    ;

    companion object {
        /** Returns the part at [x] on the overview of [viewport]; one pixel is [pixel] wide in x. */
        fun at(x: Double, viewport: Viewport, pixel: Double): OverviewGrip {
            val visible = viewport.visible
            val reach = EDGE * pixel
            // A quarter at most, so that the middle of a narrow visible range can still be grabbed.
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
