package badlog.viewer.draw.path

import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes

/**
 * Draws a trail pixel by pixel. Every pixel that contains a sample is drawn, in the order of the samples, but none twice. So a picture
 * needs at most as many strokes as it has pixels, however many samples there are.
 *
 * Blocks of the [pyramid] that are invisible, within one pixel, or where everything is drawn already are skipped. Where the trail is
 * straight, a few samples of a block are enough. Filled areas become rows of pixels.
 */
internal class TrailDrawing(private val pyramid: TrailPyramid) {
    private val pixels = TakenPixels()

    /**
     * Adds the samples from [start] until [end] to [strokes], which is cleared first. If lines are dense, strokes may be rows of pixels;
     * dense dots are always rows of pixels.
     *
     * @param isJoined whether samples are joined by lines; otherwise each is a dot.
     */
    fun draw(start: Int, end: Int, x: Scale, y: Scale, width: Int, height: Int, isJoined: Boolean, strokes: Strokes) {
        pixels.begin(width, height)
        strokes.begin()
        val trail = pyramid.trail
        val bendX = x.unitsPerPixel * BEND
        val bendY = y.unitsPerPixel * BEND
        var lastCell = NONE
        var lastX = 0.0
        var lastY = 0.0
        var wasInside = false
        var isDown = false
        var last = start
        var drawn = 0
        pyramid.visit(start, end, { boxes, at, count ->
            pixels.isDone(
                left = x.placeOf(boxes[at]),
                right = x.placeOf(boxes[at + 1]),
                bottom = y.placeOf(boxes[at + 2]),
                top = y.placeOf(boxes[at + 3]),
                count,
            )
        }, { i ->
            last = i
            val px = x.placeOf(trail.x[i])
            val py = y.placeOf(trail.y[i])
            val cell = if (px.isNaN() || py.isNaN()) NONE else pixels.cellOf(px, py)
            // Within a pixel, the line continues from its entry into the pixel.
            if (cell == NONE || cell != lastCell) {
                strokes.lift()
                isDown = false
                lastCell = cell
                lastX = px
                lastY = py
                wasInside = pixels.isInside(px, py)
            }
        }, { block -> if (isJoined) pyramid.strideOf(block, bendX, bendY) else 1 }) { i ->
            val px = x.placeOf(trail.x[i])
            val py = y.placeOf(trail.y[i])
            if (px.isNaN() || py.isNaN()) {
                strokes.lift()
                isDown = false
                lastCell = NONE
            } else {
                val isInside = pixels.isInside(px, py)
                val cell = if (isInside) pixels.innerCellOf(px, py) else pixels.cellOf(px, py)
                // Outside the picture, places in the same cell can be far apart.
                if (cell != lastCell || !isInside) {
                    if (!isJoined || lastCell == NONE) {
                        // A last sample without a successor is still visible.
                        if (pixels.take(cell)) strokes.dot(px, py)
                    } else if (pixels.takeSegment(lastX, lastY, px, py, cell, isInside && wasInside)) {
                        if (!isDown) strokes.add(lastX, lastY)
                        strokes.add(px, py)
                        isDown = true
                        drawn += i - last
                    } else if (isDown) {
                        strokes.lift()
                        isDown = false
                    }
                    lastCell = cell
                    lastX = px
                    lastY = py
                    wasInside = isInside
                }
            }
            last = i
        }
        strokes.lift()
        if (!isJoined) drawn = strokes.dotsSize / 2
        strokes.isDense = drawn > DENSE
        // Filled areas need far fewer strokes this way.
        if (strokes.isDense && (!isJoined || pixels.runs(null, gap = 0) < drawn / 2)) {
            strokes.begin()
            pixels.runs(strokes, gap = if (isJoined) 0 else DOT_GAP)
        }
    }
}

private const val NONE = -1

/** The maximum distance in pixels between a line and the samples that it passes over; less is invisible. */
private const val BEND = 0.25

/** The number of free pixels between two dots that the dots cover: they are 3.5 pixels wide, or more. */
private const val DOT_GAP = 2

/** The number of samples above which a trail is drawn in the thinnest lines, or as rows of dots. */
private const val DENSE = 20_000
