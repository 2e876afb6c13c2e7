package badlog.viewer.draw.path

import badlog.core.analysis.Span
import badlog.signals.pose.PoseRole
import badlog.viewer.draw.axis.Ticks
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.pen.PenImage
import badlog.viewer.draw.pen.Points
import badlog.viewer.draw.pen.TextSide

internal class XyDrawing(frame: XyFrame, private val plot: XyPlot) {
    private val pen = frame.pen
    private val seen = frame.seen
    private val width = frame.width
    private val height = frame.height
    private val colors = frame.colors
    private val density = pen.density
    private val x = seen.xScale(width)
    private val y = seen.yScale(height)
    private val letters = LETTERS * density

    /** Draws the background of the traces: the grid, and the field with its [picture]. */
    fun ground(picture: PenImage?) = clipped {
        val field = plot.field
        if (picture != null && plot.isField) {
            field.image?.plane(field, picture.width, picture.height)?.let { shown ->
                val (left, top, wide, high) = seen.boxOf(shown, width, height)
                pen.image(picture, left, top, wide, high, PICTURE)
            }
        }
        val grid = Points()
        for (value in Ticks.ofX(seen.x, width / density).values) grid.line(x.placeOf(value), 0.0, x.placeOf(value), height)
        for (value in Ticks.ofY(seen.y, height / density).values) grid.line(0.0, y.placeOf(value), width, y.placeOf(value))
        pen.segments(grid, colors[Shade.GRID], density)
        if (!plot.isField) return@clipped
        val corners = doubleArrayOf(0.0, 0.0, field.length, 0.0, field.length, field.width, 0.0, field.width)
        pen.chain(placed(corners), isClosed = true, colors[Shade.MUTED], LINE * density)
        fun wall(at: Double) = placed(doubleArrayOf(at, 0.0, at, field.width))
        pen.segments(wall(field.length / 2), faded(colors[Shade.MUTED], QUIET), density)
        pen.segments(wall(0.0), BLUE_WALL, WALL * density)
        pen.segments(wall(field.length), RED_WALL, WALL * density)
    }

    /** Draws the numbers and the titles of both axes around the frame, with [left] pixels to its left. */
    fun axes(left: Double) {
        val muted = colors[Shade.MUTED]
        val below = height + (GAP + LETTERS / 2) * density
        val across = Ticks.ofX(seen.x, width / density)
        val room = width - pen.widthOf(plot.xTitle, letters) - 2 * letters
        val texts = across.texts
        across.values.forEachIndexed { i, value ->
            if (x.placeOf(value) < room) pen.text(texts[i], x.placeOf(value), below, letters, muted, TextSide.CENTER)
        }
        pen.text(plot.xTitle, width, below, letters, muted, TextSide.LEFT)
        val up = Ticks.ofY(seen.y, height / density)
        val numbers = up.texts
        up.values.forEachIndexed { i, value ->
            if (y.placeOf(value) > 2 * letters) pen.text(numbers[i], -GAP * density, y.placeOf(value), letters, muted, TextSide.LEFT)
        }
        // A long title extends over the frame.
        val end = maxOf(-GAP * density, pen.widthOf(plot.yTitle, letters) - left)
        pen.text(plot.yTitle, end, letters / 2, letters, muted, TextSide.LEFT)
    }

    /**
     * Draws the part of [traces] in [visible]. On a field, it also draws the rest faintly, unless the visible part [isAll].
     *
     * @param strokes are reused: allocating arrays for a million places in each frame takes long.
     * @param colorOf returns the index of the color of a trace.
     */
    fun traces(traces: List<XyTrace>, visible: Span, isAll: Boolean, strokes: Strokes, colorOf: (XyTrace) -> Int) = clipped {
        for (trace in traces) {
            if (trace.followers.isNotEmpty()) continue
            val color = colors.line(colorOf(trace))
            if (!isAll && plot.isField) trace(trace, EVERYTHING, strokes, faded(color, FAINT))
            trace(trace, visible, strokes, color)
        }
    }

    private fun trace(trace: XyTrace, span: Span, strokes: Strokes, color: Int) {
        trace.draw(span, seen, width.toInt(), height.toInt(), strokes)
        val size = DOT * density
        if (trace.isJoined) {
            val isDashed = trace.role == PoseRole.PLANNED && !strokes.isDense
            pen.lines(strokes, color, if (strokes.isDense) 0.0 else LINE * density, if (isDashed) DASH * density else 0.0)
        } else {
            // The rows of pixels that many dots form.
            for (i in 0 until strokes.count) {
                val at = strokes.startOf(i)
                val left = strokes.points[at] + (1 - size) / 2
                pen.rectangle(left, strokes.points[at + 1] - size / 2, strokes.points[at + 2] - strokes.points[at] - 1 + size, size, color)
            }
        }
        for (i in 0 until strokes.dotsSize step 2) {
            pen.rectangle(strokes.dots[i] - size / 2, strokes.dots[i + 1] - size / 2, size, size, color)
        }
    }

    /**
     * Draws the line [fit] through the samples, with its values as [text] in the corner. It leaves room above the text for [others] other
     * ones.
     */
    fun fit(fit: LineFit, text: String, others: Int) = clipped {
        fun at(value: Double) = fit.offset + fit.slope * value
        val ends = doubleArrayOf(seen.x.from, at(seen.x.from), seen.x.to, at(seen.x.to))
        pen.segments(placed(ends), colors[Shade.MUTED], LINE * density)
        note(text, width, others * NOTE * density, colors[Shade.TEXT])
    }

    /** Draws rings at resets of the pose in [visible]. */
    fun resets(visible: Span) = clipped {
        val trail = plot.driven?.trail ?: return@clipped
        val ends = placed(trail.resetsIn(visible))
        for (i in 0 until ends.size step 2) {
            pen.ring(ends.values[i], ends.values[i + 1], RESET * density, colors[Shade.MUTED], LINE * density)
        }
    }

    /** Draws a ring at the place where the robot left its plan, with [text]. */
    fun departure(departure: Departure, text: String) = clipped {
        val trail = plot.driven?.trail ?: return@clipped
        val left = x.placeOf(trail.x[departure.index])
        val top = y.placeOf(trail.y[departure.index])
        pen.ring(left, top, RING * density, colors[Shade.WARNING], LINE * density)
        note(text, left + RING * density, top + RING * density, colors[Shade.WARNING])
    }

    private fun note(text: String, atX: Double, atY: Double, color: Int) {
        val wide = pen.widthOf(text, letters)
        val left = atX.coerceIn(0.0, maxOf(0.0, width - wide))
        val top = atY.coerceIn(0.0, maxOf(0.0, height - NOTE * density))
        pen.rectangle(left, top, wide, NOTE * density, faded(colors[Shade.SURFACE], VEIL))
        pen.text(text, left, top + NOTE / 2 * density, letters, color)
    }

    /**
     * Draws everything that is not [hidden] at its place at [time]. A robot shows its front, a planned one only its outline; anything else
     * is a dot, or a ring for the second cursor.
     *
     * @param colorOf returns the palette's index for a color of the plot.
     */
    fun marks(time: Double, hidden: Set<String>, isSecond: Boolean, colorOf: (Int) -> Int) = clipped {
        for (mark in plot.marksAt(time, hidden)) {
            val color = mark.color?.let { colors.line(colorOf(it)) } ?: colors[if (mark.isTarget) Shade.MUTED else Shade.ACCENT]
            val places = placed(mark.places)
            if (!mark.isDot) {
                if (mark.isFilled && !isSecond) pen.shapes(places, mark.places.size / 2, faded(color, FILL))
                pen.chain(places, mark.isClosed, color, (if (mark.isTarget) TARGET else LINE) * density)
            } else if (isSecond) {
                pen.ring(places.values[0], places.values[1], SECOND * density, color, LINE * density)
            } else {
                pen.dots(places, DOT * density, colors[Shade.SURFACE])
                pen.dots(places, (DOT - 1) * density, color)
            }
        }
    }

    private fun placed(places: DoubleArray) = Points().apply {
        for (i in places.indices step 2) add(x.placeOf(places[i]), y.placeOf(places[i + 1]))
    }

    private fun clipped(draw: () -> Unit) = pen.clip(0.0, 0.0, width, height, draw)

    private companion object {
        val EVERYTHING = Span(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY)
        const val BLUE_WALL = 0xFF2F6FDE.toInt()
        const val RED_WALL = 0xFFD93A3A.toInt()
        const val LETTERS = 11.0
        const val GAP = 6.0
        const val NOTE = 15.0
        const val LINE = 1.75
        const val TARGET = 3.5
        const val DASH = 5.0
        const val DOT = 4.0
        const val SECOND = 5.0
        const val RING = 9.0
        const val RESET = 4.0
        const val WALL = 3.0
        const val FAINT = 0.25
        const val FILL = 0.25
        const val QUIET = 0.45
        const val PICTURE = 0.6
        const val VEIL = 0.85
    }
}
