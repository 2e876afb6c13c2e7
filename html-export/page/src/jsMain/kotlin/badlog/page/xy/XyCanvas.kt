package badlog.page.xy

import badlog.page.dom.add
import badlog.page.view.Palette
import badlog.page.view.Scene
import badlog.viewer.draw.axis.Ticks
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.path.Departure
import badlog.viewer.draw.path.Plane
import badlog.viewer.draw.path.XyPlot
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLImageElement
import kotlin.math.PI

/**
 * A canvas with a frame in it, in physical pixels of the screen.
 *
 * @param wide its width, and [high] its height, in those pixels.
 */
internal class XyCanvas(private val context: CanvasRenderingContext2D, wide: Double, high: Double) {
    /** What it draws on. */
    val canvas: HTMLCanvasElement = context.canvas

    private val ratio = pixelRatio

    /** The width of the frame. */
    val width: Double

    /** The height of the frame. */
    val height: Double

    init {
        width = maxOf(1.0, wide - (LEFT + RIGHT) * ratio)
        height = maxOf(1.0, high - (TOP + BOTTOM) * ratio)
        context.translate(LEFT * ratio, TOP * ratio)
        context.font = "${LETTERS * ratio}px system-ui, sans-serif"
    }

    /** Returns the fraction of the frame's width at [clientX] in the window. */
    fun shareX(clientX: Double): Double = ((clientX - canvas.getBoundingClientRect().left - LEFT) * ratio) / width

    /** Returns the fraction of the frame's height at [clientY] in the window, from its top. */
    fun shareY(clientY: Double): Double = ((clientY - canvas.getBoundingClientRect().top - TOP) * ratio) / height

    fun clear() = context.clearRect(-LEFT * ratio, -TOP * ratio, canvas.width.toDouble(), canvas.height.toDouble())

    /** Sets the [color] for what is drawn next. */
    fun color(color: String, opacity: Double = 1.0) {
        context.strokeStyle = color
        context.fillStyle = color
        context.globalAlpha = opacity
        context.lineWidth = LINE * ratio
    }

    /** Draws a trace: lines and single dots if it [isJoined]; otherwise dots, or for many of them the rows of pixels that they are in. */
    fun trace(strokes: Strokes, isJoined: Boolean, isDashed: Boolean) = clipped {
        if (isJoined) lines(strokes, isDashed)
        val size = DOT * ratio
        for (i in 0 until strokes.dotsSize step 2) context.fillRect(strokes.dots[i] - size / 2, strokes.dots[i + 1] - size / 2, size, size)
        if (isJoined) return@clipped
        for (i in 0 until strokes.count) {
            val at = strokes.startOf(i)
            val long = strokes.points[at + 2] - strokes.points[at] - 1 + size
            context.fillRect(strokes.points[at] + (1 - size) / 2, strokes.points[at + 1] - size / 2, long, size)
        }
    }

    private fun lines(strokes: Strokes, isDashed: Boolean) {
        context.setLineDash(if (isDashed && !strokes.isDense) arrayOf(6 * ratio, 4 * ratio) else emptyArray())
        if (strokes.isDense) context.lineWidth = 1.0
        context.beginPath()
        for (i in 0 until strokes.count) {
            val start = strokes.startOf(i)
            context.moveTo(strokes.points[start], strokes.points[start + 1])
            for (at in start + 2 until strokes.endOf(i) step 2) context.lineTo(strokes.points[at], strokes.points[at + 1])
        }
        context.stroke()
    }

    /** Draws the line that joins [places], which alternate x and y. */
    fun chain(places: DoubleArray, seen: Plane, isClosed: Boolean, isFilled: Boolean = false) = clipped {
        val x = seen.xScale(width)
        val y = seen.yScale(height)
        context.beginPath()
        for (i in places.indices step 2) context.lineTo(x.placeOf(places[i]), y.placeOf(places[i + 1]))
        if (isClosed) context.closePath()
        context.stroke()
        if (isFilled) {
            context.globalAlpha = FILL
            context.fill()
            context.globalAlpha = 1.0
        }
    }

    /** Draws a dot at ([atX], [atY]), or a ring as wide as [radius]. */
    fun dot(atX: Double, atY: Double, seen: Plane, radius: Double? = null) = clipped {
        context.beginPath()
        context.arc(seen.xScale(width).placeOf(atX), seen.yScale(height).placeOf(atY), (radius ?: DOT) * ratio, 0.0, 2 * PI)
        if (radius == null) context.fill() else context.stroke()
    }

    /** Draws what is behind the traces: the [picture] of a field, or a grid, and the numbers of both axes. */
    fun drawGround(seen: Plane, plot: XyPlot, picture: HTMLImageElement?, palette: Palette) {
        val x = seen.xScale(width)
        val y = seen.yScale(height)
        val field = plot.field
        if (plot.isField && picture?.complete == true && picture.naturalWidth > 0) {
            field.image?.plane(field, picture.naturalWidth, picture.naturalHeight)?.let { shown ->
                val box = seen.boxOf(shown, width, height)
                context.globalAlpha = PICTURE
                clipped { context.drawImage(picture, box[0], box[1], box[2], box[3]) }
            }
        }
        fun line(fromX: Double, fromY: Double, toX: Double, toY: Double) =
            chain(doubleArrayOf(fromX, fromY, toX, toY), seen, isClosed = false)
        val across = Ticks.ofX(seen.x, width / ratio)
        val up = Ticks.ofY(seen.y, height / ratio)
        color(palette[Shade.GRID])
        context.lineWidth = ratio
        for (value in across.values) line(value, seen.y.from, value, seen.y.to)
        for (value in up.values) line(seen.x.from, value, seen.x.to, value)
        color(palette[Shade.MUTED])
        context.asDynamic().textAlign = "center"
        val room = width - context.measureText(plot.xTitle).width - 2 * LETTERS * ratio
        across.values.forEachIndexed { i, value ->
            if (x.placeOf(value) < room) context.fillText(across.texts[i], x.placeOf(value), height + BASE * ratio)
        }
        context.asDynamic().textAlign = "right"
        context.fillText(plot.xTitle, width, height + BASE * ratio)
        up.values.forEachIndexed { i, value ->
            if (y.placeOf(value) > 2 * LETTERS * ratio) context.fillText(up.texts[i], -GAP * ratio, y.placeOf(value) + LETTERS / 3 * ratio)
        }
        // A long title extends over the frame.
        context.fillText(plot.yTitle, maxOf(-GAP * ratio, context.measureText(plot.yTitle).width - LEFT * ratio), LETTERS * ratio)
        if (!plot.isField) return
        chain(doubleArrayOf(0.0, 0.0, field.length, 0.0, field.length, field.width, 0.0, field.width), seen, isClosed = true)
        color(palette[Shade.MUTED], QUIET)
        line(field.length / 2, 0.0, field.length / 2, field.width)
        color(BLUE)
        context.lineWidth = WALL * ratio
        line(0.0, 0.0, 0.0, field.width)
        color(RED)
        context.lineWidth = WALL * ratio
        line(field.length, 0.0, field.length, field.width)
    }

    /** Draws the result of [plot]: where the robot departed from its plan, or the fitted line through the samples with its values. */
    fun drawNotes(seen: Plane, plot: XyPlot, departure: Departure?, scene: Scene) {
        plot.lineFit(scene.range.now)?.let { fit ->
            color(scene.palette[Shade.MUTED])
            fun at(value: Double) = listOf(value, fit.offset + fit.slope * value)
            chain((at(seen.x.from) + at(seen.x.to)).toDoubleArray(), seen, isClosed = false)
            note(plot.textOf(fit), width, 0.0, scene.palette[Shade.TEXT], scene.palette)
        }
        val trail = plot.driven?.trail ?: return
        if (departure == null) return
        val atX = trail.x[departure.index]
        val atY = trail.y[departure.index]
        color(scene.palette[Shade.WARNING])
        dot(atX, atY, seen, RING)
        val place = RING * ratio
        val text = departure.text(scene.xText(departure.time))
        note(
            text,
            seen.xScale(width).placeOf(atX) + place,
            seen.yScale(height).placeOf(atY) + place,
            scene.palette[Shade.WARNING],
            scene.palette,
        )
    }

    /** Covers the part of the frame between two places, given as fractions of it. */
    fun cover(fromX: Double, fromY: Double, toX: Double, toY: Double, palette: Palette) = clipped {
        color(palette[Shade.ACCENT], FILL)
        context.fillRect(fromX * width, fromY * height, (toX - fromX) * width, (toY - fromY) * height)
    }

    private fun note(text: String, atX: Double, atY: Double, color: String, palette: Palette) {
        val wide = context.measureText(text).width
        val left = atX.coerceIn(0.0, maxOf(0.0, width - wide))
        val top = atY.coerceIn(0.0, height - NOTE * ratio)
        color(palette[Shade.SURFACE], VEIL)
        context.fillRect(left, top, wide, NOTE * ratio)
        color(color)
        context.asDynamic().textAlign = "left"
        context.fillText(text, left, top + LETTERS * ratio)
    }

    private inline fun clipped(draw: () -> Unit) {
        context.save()
        context.beginPath()
        context.rect(0.0, 0.0, width, height)
        context.clip()
        draw()
        context.restore()
    }

    internal companion object {
        /** Creates one that covers [host]. */
        fun over(host: HTMLElement): XyCanvas {
            val canvas = host.add("canvas", "xy").unsafeCast<HTMLCanvasElement>()
            canvas.width = (host.clientWidth * pixelRatio).toInt()
            canvas.height = (host.clientHeight * pixelRatio).toInt()
            val context = canvas.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
            return XyCanvas(context, canvas.width.toDouble(), canvas.height.toDouble())
        }

        // The same as in other graphs.
        private const val LEFT = 62
        private const val RIGHT = 14
        private const val TOP = 6
        private const val BOTTOM = 26

        /** Returns the height of a canvas [width] CSS pixels wide whose frame shows all of [plane], with the same scale for x and y. */
        fun heightOf(plane: Plane, width: Int): Int = ((width - LEFT - RIGHT) * plane.y.width / plane.x.width).toInt() + TOP + BOTTOM

        private const val BASE = 18
        private const val GAP = 6
        private const val LETTERS = 11.0
        private const val NOTE = 15
        private const val LINE = 1.75
        private const val DOT = 3.5
        private const val RING = 9.0
        private const val WALL = 3
        private const val FILL = 0.25
        private const val QUIET = 0.4
        private const val PICTURE = 0.6
        private const val VEIL = 0.85
        private const val BLUE = "#2f6fde"
        private const val RED = "#d93a3a"
    }
}
