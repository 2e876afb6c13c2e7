package badlog.window.export.figure

import badlog.viewer.draw.color.modeOpacity
import badlog.window.theme.Palette
import org.jetbrains.letsPlot.coord.coordCartesian
import org.jetbrains.letsPlot.coord.coordFixed
import org.jetbrains.letsPlot.geom.geomPath
import org.jetbrains.letsPlot.geom.geomPoint
import org.jetbrains.letsPlot.geom.geomRect
import org.jetbrains.letsPlot.geom.geomRibbon
import org.jetbrains.letsPlot.geom.geomText
import org.jetbrains.letsPlot.geom.geomVLine
import org.jetbrains.letsPlot.gggrid
import org.jetbrains.letsPlot.ggsize
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.label.labs
import org.jetbrains.letsPlot.letsPlot
import org.jetbrains.letsPlot.sampling.samplingNone
import org.jetbrains.letsPlot.scale.guideLegend
import org.jetbrains.letsPlot.scale.scaleColorManual
import org.jetbrains.letsPlot.scale.scaleFillIdentity
import org.jetbrains.letsPlot.scale.scaleFillManual
import org.jetbrains.letsPlot.scale.scaleLinetypeManual
import org.jetbrains.letsPlot.scale.scaleXContinuous
import org.jetbrains.letsPlot.scale.scaleYContinuous
import org.jetbrains.letsPlot.Figure as LetsPlotFigure

/** Returns the drawing of [figure] by lets-plot, in the sizes of [options]; always in the light theme, as for paper. */
internal fun drawingOf(figure: Figure, options: FigureOptions): LetsPlotFigure {
    val sizes = figure.frames.indices.map { FrameSize.of(figure, it, options) }
    val plots = figure.frames.mapIndexed { i, frame -> plotOf(figure, frame, sizes[i]) }
    val heights = sizes.map { it.height }
    return gggrid(plots, ncol = 1, heights = heights, vspace = 0, align = true) + ggsize(options.width, heights.sum())
}

private fun plotOf(figure: Figure, frame: FigureFrame, size: FrameSize): Plot {
    val behind = frame.plane?.let(::ground) ?: behind(figure.marks, frame)
    val lines = if (frame.lanes.isEmpty()) drawLines(behind, frame, size) else drawLanes(behind, figure, frame, size)
    val content = frame.plane?.let(lines::withShapesOf) ?: above(lines, figure.marks, frame)
    val x = frame.plane?.x ?: figure.x
    val limits = x.from to x.to
    val yLimits = frame.y.from to frame.y.to
    val yBreaks = frame.lanes.indices.map { frame.lanes.size - it - 0.5 }.takeIf { it.isNotEmpty() }
    val labels = frame.lanes.map { it.label }.takeIf { it.isNotEmpty() }
    val base = content +
        scaleXContinuous(expand = NO_MARGIN) +
        scaleYContinuous(expand = NO_MARGIN, breaks = yBreaks, labels = labels) +
        (if (frame.plane?.isField == true) coordFixed(1, limits, yLimits) else coordCartesian(limits, yLimits)) +
        labs(
            title = if (size.isFirst) figure.title else frame.title,
            subtitle = frame.title.takeIf { size.isFirst },
            x = frame.plane?.xTitle ?: figure.xTitle.takeIf { size.isLast }.orEmpty(),
            y = frame.yTitle,
        )
    return base + figureTheme(size, hasLanes = frame.lanes.isNotEmpty())
}

/** Returns an empty frame with what is behind its lines: when the robot was enabled, and where something happened. */
private fun behind(marks: FigureMarks, frame: FigureFrame): Plot {
    var plot = letsPlot()
    for ((color, bands) in marks.bands.groupBy { it.color }) {
        val data = mapOf("from" to bands.map { it.from }, "to" to bands.map { it.to })
        plot += geomRect(
            data,
            ymin = frame.y.from,
            ymax = frame.y.to,
            fill = color,
            alpha = modeOpacity(isDark = false),
            size = 0,
            sampling = samplingNone,
            showLegend = false,
            tooltips = null,
        ) {
            xmin = "from"
            xmax = "to"
        }
    }
    return plot.withLinesAt(marks.events, hexOf(Palette.LIGHT.event), EVENT).withLinesAt(marks.notes, hexOf(Palette.LIGHT.accent), NOTE)
}

/** Returns it with a vertical line at each of [places]. */
private fun Plot.withLinesAt(places: List<Double>, color: String, opacity: Double): Plot {
    if (places.isEmpty()) return this
    return this +
        geomVLine(mapOf("at" to places), color = color, alpha = opacity, size = 0.5, sampling = samplingNone, showLegend = false) {
            xintercept = "at"
        }
}

/** Returns [plot] with the cursors, and the marks of findings along its bottom. */
private fun above(plot: Plot, marks: FigureMarks, frame: FigureFrame): Plot = marks.findings.groupBy {
    it.color
}.entries.fold(plot.withLinesAt(marks.cursors, hexOf(Palette.LIGHT.accent), CURSOR)) { drawn, (color, points) ->
    drawn + geomPoint(
        mapOf("at" to points.map { it.x }),
        y = frame.y.from + frame.y.width * FINDING_PLACE,
        color = color,
        shape = DIAMOND,
        size = FINDING,
        sampling = samplingNone,
        showLegend = false,
        tooltips = null,
    ) { x = "at" }
}

private fun drawLines(behind: Plot, frame: FigureFrame, size: FrameSize): Plot {
    val keys = frame.lines.indices.map { it.toString() }
    val colors = frame.lines.map { it.color }
    val labels = frame.lines.map { unbroken(it.label) }
    val points = LinePoints(frame)
    val legend = if (size.legendRows > 0) guideLegend(nrow = size.legendRows, byRow = true) else "none"
    val hasDashes = frame.lines.any { it.isDashed }
    var plot = behind +
        scaleColorManual(colors, breaks = keys, labels = labels, limits = keys, name = "", guide = legend)
    if (frame.isFilled) {
        val base = 0.0.coerceIn(frame.y.from, frame.y.to)
        val filled = points.strokes + ("base" to List(points.strokes.getValue("x").size) { base })
        plot += geomRibbon(filled, size = 0, alpha = FILL, sampling = samplingNone, showLegend = false, tooltips = null) {
            x = "x"
            ymin = "base"
            ymax = "y"
            group = "piece"
            fill = "line"
        }
        plot += scaleFillManual(colors, breaks = keys, limits = keys, guide = "none")
    }
    plot += geomPath(points.strokes, size = STROKE, sampling = samplingNone, tooltips = null) {
        x = "x"
        y = "y"
        group = "piece"
        color = "line"
        if (hasDashes) linetype = "line"
    }
    if (hasDashes) {
        // A legend is shared with the colors' where all but the looks is the same.
        val types = frame.lines.map { if (it.isDashed) DASHED else SOLID }
        plot += scaleLinetypeManual(types, breaks = keys, labels = labels, limits = keys, name = "", guide = legend)
    }
    if (points.dots.getValue("x").isNotEmpty()) {
        plot += geomPoint(points.dots, size = DOT, sampling = samplingNone, showLegend = false, tooltips = null) {
            x = "x"
            y = "y"
            color = "line"
        }
    }
    return plot
}

private fun drawLanes(behind: Plot, figure: Figure, frame: FigureFrame, size: FrameSize): Plot {
    val blocks = frame.lanes.flatMapIndexed { i, lane -> lane.blocks.map { frame.lanes.size - i - 1.0 to it } }
    val data = mapOf(
        "from" to blocks.map { it.second.from },
        "to" to blocks.map { it.second.to },
        "low" to blocks.map { it.first + LANE_GAP },
        "high" to blocks.map { it.first + 1 - LANE_GAP },
        "color" to blocks.map { it.second.color },
    )
    val letterWidth = LETTER_WIDTH * figure.x.width / size.plotWidth
    val named = blocks.mapNotNull { (lane, block) ->
        val letters = ((block.to - block.from) / letterWidth).toInt() - 1
        if (block.name.length > letters && letters < MIN_LETTERS) null else Triple(lane, block, plainLine(block.name, letters))
    }
    val texts = mapOf(
        "at" to named.map { it.second.from + letterWidth / 2 },
        "middle" to named.map { it.first + 0.5 },
        "text" to named.map { it.third },
    )
    val rects = geomRect(data, size = 0, sampling = samplingNone, tooltips = null) {
        xmin = "from"
        xmax = "to"
        ymin = "low"
        ymax = "high"
        fill = "color"
    }
    val names = geomText(texts, hjust = "left", size = NAME_SIZE, color = hexOf(Palette.LIGHT.text), sampling = samplingNone) {
        x = "at"
        y = "middle"
        label = "text"
    }
    return behind + rects + names + scaleFillIdentity()
}

// A legend would break long labels at their spaces, without room for the lines.
private fun unbroken(label: String) = label.replace(' ', NO_BREAK)

private val NO_MARGIN = listOf(0, 0)
private const val NO_BREAK = '\u00a0'
private const val SOLID = 1
private const val DASHED = 2
private const val STROKE = 0.8
private const val DOT = 1.6
private const val FILL = 0.15
private const val EVENT = 0.5
private const val NOTE = 1.0
private const val CURSOR = 1.0
private const val FINDING = 3.4

/** The distance of a finding's mark from the frame's bottom, as a fraction of its height. */
private const val FINDING_PLACE = 0.03
private const val DIAMOND = 18
private const val LANE_GAP = 0.06
private const val NAME_SIZE = 4.6

/** The average width of a letter in a state's name, in pixels. */
private const val LETTER_WIDTH = 6.2
private const val MIN_LETTERS = 5

/**
 * The points of [frame]'s lines as columns: `x`, `y`, the number of their `line` as a text, and of their `piece`.
 *
 * @property strokes the joined points.
 * @property dots the points with a dot.
 */
internal class LinePoints(frame: FigureFrame) {
    private val joined = Columns()
    private val alone = Columns()
    val strokes: Map<String, List<Any>> get() = joined.all
    val dots: Map<String, List<Any>> get() = alone.all

    init {
        var piece = 0
        frame.lines.forEachIndexed { i, line ->
            val strokes = line.strokes
            for (stroke in 0 until strokes.count) {
                piece++
                val from = strokes.startOf(stroke)
                val until = strokes.endOf(stroke)
                if (until - from > 2) joined.add(strokes.points, from, until, i, piece)
            }
            alone.add(strokes.dots, 0, strokes.dotsSize, i, piece)
        }
    }

    private class Columns {
        private val x = ArrayList<Double>()
        private val y = ArrayList<Double>()
        private val line = ArrayList<String>()
        private val piece = ArrayList<Int>()

        val all: Map<String, List<Any>> = mapOf("x" to x, "y" to y, "line" to line, "piece" to piece)

        fun add(points: DoubleArray, from: Int, until: Int, lineNumber: Int, pieceNumber: Int) {
            val name = lineNumber.toString()
            for (at in from until until step 2) {
                x += points[at]
                y += points[at + 1]
                line += name
                piece += pieceNumber
            }
        }
    }
}
