package badlog.viewer.draw.path

import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.pen.Pen

/**
 * The frame in which a graph of y over x is drawn. Its top left corner is the pen's origin.
 *
 * @property seen the visible part of the plane.
 * @property width the width in physical pixels.
 * @property height the height in physical pixels.
 */
class XyFrame(
    internal val pen: Pen,
    internal val seen: Plane,
    internal val width: Double,
    internal val height: Double,
    internal val colors: PenColors,
)
