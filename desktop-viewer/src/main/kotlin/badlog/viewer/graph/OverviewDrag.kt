package badlog.viewer.graph

import badlog.analysis.Span
import badlog.plot.range.Viewport

/** What a drag on the overview takes hold of. */
internal enum class OverviewGrip {
    /** The left edge of what is visible. */
    LEFT,

    /** Its right edge. */
    RIGHT,

    /** All of it. */
    WINDOW,

    /** Nothing: a new part is chosen. */
    NEW,
}

/** What is at [x] of the overview of [viewport]; edges are [reach] wide at each side. */
internal fun gripAt(x: Double, viewport: Viewport, reach: Double): OverviewGrip {
    val visible = viewport.visible
    // Of a narrow window the middle can still be taken.
    val inside = minOf(reach, visible.width / 4)
    return when {
        !viewport.isZoomed -> OverviewGrip.NEW
        x in visible.from - reach..visible.from + inside -> OverviewGrip.LEFT
        x in visible.to - inside..visible.to + reach -> OverviewGrip.RIGHT
        x in visible -> OverviewGrip.WINDOW
        else -> OverviewGrip.NEW
    }
}

/**
 * What is seen when [grip] was taken at [start] and is at [x] now.
 *
 * @param before what was visible at the start.
 */
internal fun Viewport.overviewDragged(grip: OverviewGrip, before: Span, start: Double, x: Double): Viewport = when (grip) {
    OverviewGrip.LEFT -> moved(minOf(x, before.to), before.to)
    OverviewGrip.RIGHT -> moved(before.from, maxOf(x, before.from))
    OverviewGrip.WINDOW -> moved(before.from + x - start, before.to + x - start)
    OverviewGrip.NEW -> moved(start, x)
}
