package badlog.viewer.input

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
