package badlog.window.export.figure

import badlog.window.graph.xy.BLUE_WALL
import badlog.window.graph.xy.RED_WALL
import badlog.window.theme.Palette
import org.jetbrains.letsPlot.Stat
import org.jetbrains.letsPlot.geom.geomLabel
import org.jetbrains.letsPlot.geom.geomPath
import org.jetbrains.letsPlot.geom.geomPoint
import org.jetbrains.letsPlot.geom.geomPolygon
import org.jetbrains.letsPlot.geom.geomRect
import org.jetbrains.letsPlot.intern.GeomKind
import org.jetbrains.letsPlot.intern.Layer
import org.jetbrains.letsPlot.intern.Options
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.intern.layer.GeomOptions
import org.jetbrains.letsPlot.letsPlot
import org.jetbrains.letsPlot.pos.positionIdentity
import org.jetbrains.letsPlot.sampling.samplingNone

/** An empty frame with what is behind the lines of [plane]: the field with its picture, its center line and the alliances' walls. */
internal fun ground(plane: FigurePlane): Plot {
    val field = plane.field ?: return letsPlot()
    val picture = plane.picture?.let { letsPlot() + PictureLayer(it) + veil(it) } ?: letsPlot()
    val outline = doubleArrayOf(0.0, 0.0, field.length, 0.0, field.length, field.width, 0.0, field.width)
    fun wall(x: Double) = doubleArrayOf(x, 0.0, x, field.width)
    return picture
        .withPath(FigureShape(outline, hexOf(Palette.LIGHT.muted), isClosed = true), OUTLINE)
        .withPath(FigureShape(wall(field.length / 2), hexOf(Palette.LIGHT.muted)), OUTLINE / 2)
        .withPath(FigureShape(wall(0.0), hexOf(BLUE_WALL)), WALL)
        .withPath(FigureShape(wall(field.length), hexOf(RED_WALL)), WALL)
}

/** This with the shapes and labels of [plane]. */
internal fun Plot.withShapesOf(plane: FigurePlane): Plot {
    val shapes = plane.shapes.fold(this) { drawn, shape -> if (shape.isDot) drawn.withDot(shape) else drawn.withPath(shape, SHAPE) }
    return plane.labels.fold(shapes) { drawn, label -> drawn.withLabel(label) }
}

private fun Plot.withPath(shape: FigureShape, size: Double): Plot {
    val filled = if (!shape.isFilled) {
        this
    } else {
        this +
            geomPolygon(
                shape.columns,
                fill = shape.color,
                alpha = FILL,
                size = 0,
                sampling = samplingNone,
                showLegend = false,
                tooltips = null,
            ) {
                x = "x"
                y = "y"
            }
    }
    return filled +
        geomPath(shape.columns, color = shape.color, size = size, sampling = samplingNone, showLegend = false, tooltips = null) {
            x = "x"
            y = "y"
        }
}

private fun Plot.withDot(shape: FigureShape): Plot = this + geomPoint(
    shape.columns,
    color = shape.color,
    shape = if (shape.isRing) RING_SHAPE else DOT_SHAPE,
    size = if (shape.isRing) RING else DOT,
    stroke = if (shape.isRing) RING_STROKE else 0.0,
    sampling = samplingNone,
    showLegend = false,
    tooltips = null,
) {
    x = "x"
    y = "y"
}

private fun Plot.withLabel(label: FigureLabel): Plot = this + geomLabel(
    mapOf("x" to listOf(label.x), "y" to listOf(label.y), "text" to listOf(label.text)),
    color = label.color,
    fill = "white",
    alpha = LABEL_VEIL,
    labelSize = 0,
    size = LABEL,
    hjust = if (label.isLeft) 1 else 0,
    vjust = if (label.isAbove) 0 else 1,
    sampling = samplingNone,
    showLegend = false,
    tooltips = null,
) {
    x = "x"
    y = "y"
    this.label = "text"
}

/** Lets-plot has such a layer, but creates its picture from numbers: here it is the file's own bytes. */
private class PictureLayer(private val picture: FigurePicture) :
    Layer(Options.empty(), geom = GeomOptions(GeomKind.IMAGE), stat = Stat.identity, position = positionIdentity, showLegend = false) {
    override fun seal(): Options = with(picture.plane) {
        Options.of("href" to picture.source, "xmin" to x.from, "ymin" to y.from, "xmax" to x.to, "ymax" to y.to)
    }
}

/** Returns the layer that mutes a picture as on the screen. */
private fun veil(picture: FigurePicture) = with(picture.plane) {
    geomRect(
        mapOf("from" to listOf(x.from), "to" to listOf(x.to), "low" to listOf(y.from), "high" to listOf(y.to)),
        fill = "white",
        alpha = PICTURE_VEIL,
        size = 0,
        sampling = samplingNone,
        showLegend = false,
        tooltips = null,
    ) {
        xmin = "from"
        xmax = "to"
        ymin = "low"
        ymax = "high"
    }
}

private const val OUTLINE = 0.8
private const val WALL = 1.6
private const val SHAPE = 0.9
private const val FILL = 0.25
private const val DOT = 2.4
private const val DOT_SHAPE = 16
private const val RING = 4.5
private const val RING_SHAPE = 1
private const val RING_STROKE = 1.2
private const val LABEL = 5
private const val LABEL_VEIL = 0.85
private const val PICTURE_VEIL = 0.4
