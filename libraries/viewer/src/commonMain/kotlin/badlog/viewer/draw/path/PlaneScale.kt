package badlog.viewer.draw.path

import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.curve.Scale

/** Returns the scale of this plane's x on [width] pixels. */
fun Plane.xScale(width: Double): Scale = Scale(x.from, x.to, width, farthest = FARTHEST * width)

/** Returns the scale of this plane's y on [height] pixels. */
fun Plane.yScale(height: Double): Scale = Scale.ofY(y, height)

/** The same limit as for y: coordinates far outside the screen would be too large for drawing. */
private const val FARTHEST = 50.0
