package badlog.assistant.picture

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.core.analysis.StateRuns
import badlog.viewer.draw.axis.Ticks
import badlog.viewer.draw.axis.graphAxes
import badlog.viewer.draw.axis.limitsFor
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.lineColor
import badlog.viewer.draw.color.stateOpacity
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.lane.LaneBlocks
import badlog.viewer.draw.lane.LaneLook
import badlog.viewer.draw.lane.LaneTone
import badlog.viewer.draw.mark.ModeBands
import badlog.viewer.draw.mark.ModeTimeline
import badlog.viewer.draw.mark.RobotMode
import badlog.viewer.text.shortNames
import badlog.viewer.text.withUnit
import java.awt.BasicStroke
import java.awt.Color
import java.awt.Font
import java.awt.Graphics2D
import java.awt.Rectangle
import java.awt.RenderingHints
import java.awt.geom.Ellipse2D
import java.awt.geom.Line2D
import java.awt.geom.Path2D
import java.awt.geom.Rectangle2D
import java.awt.image.BufferedImage
import java.io.ByteArrayOutputStream
import javax.imageio.ImageIO
import kotlin.math.ceil

/**
 * Graphs of a log as a picture for an assistant: a panel for the lines of each unit, and a lane for each state, over the same x; shaded
 * where the robot was enabled.
 *
 * @param title the heading.
 * @param lines what is drawn, each in its own color.
 * @param range the part of x that is drawn, not empty.
 * @param width the width of the picture, in pixels.
 */
internal class GraphPicture(
    private val view: LogView,
    private val title: String,
    lines: List<GraphSeries>,
    private val range: Span,
    private val width: Int,
) {
    private class NamedLine(val line: GraphSeries, val name: String, val color: Int)

    private class Panel(val unit: String, val lines: List<NamedLine>)

    private val panels: List<Panel>
    private val lanes: List<NamedLine>
    private val plotWidth = width - LEFT - RIGHT

    init {
        val names = shortNames(lines.map { it.topic.name })
        val named = lines.mapIndexed { i, line -> NamedLine(line, names[i].take(MAX_LETTERS), lineColor(i, isDark = false)) }
        val (states, numbers) = named.partition { it.line.states != null }
        lanes = states
        panels = graphAxes(numbers.map { it.line.unit }).map { axis -> Panel(axis.unit, axis.lines.map(numbers::get)) }
    }

    /** The height of the picture, in pixels. */
    val height: Int = TOP + panels.size * PANEL + lanes.size * LANE + BOTTOM

    /** Returns the picture as the bytes of a PNG. */
    fun png(): ByteArray {
        val image = BufferedImage(width, height, BufferedImage.TYPE_INT_RGB)
        val graphics = image.createGraphics()
        try {
            graphics.draw()
        } finally {
            graphics.dispose()
        }
        val bytes = ByteArrayOutputStream()
        ImageIO.setUseCache(false)
        ImageIO.write(image, "png", bytes)
        return bytes.toByteArray()
    }

    private fun Graphics2D.draw() {
        setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON)
        setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON)
        setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE)
        font = Font(Font.SANS_SERIF, Font.PLAIN, LETTERS)
        color = colorOf(Shade.SURFACE)
        fillRect(0, 0, width, this@GraphPicture.height)
        text(title, LEFT.toDouble(), LETTERS + 6.0, Shade.TEXT, width - LEFT - RIGHT)
        val ticks = Ticks.ofX(range, plotWidth.toDouble())
        var top = TOP
        for (panel in panels) {
            drawPanel(panel, top, ticks)
            top += PANEL
        }
        for (lane in lanes) {
            drawLane(lane, top)
            top += LANE
        }
        drawX(ticks, top)
    }

    private fun Graphics2D.drawPanel(panel: Panel, top: Int, xTicks: Ticks) {
        val plotTop = top + LEGEND
        val plotHeight = (PANEL - LEGEND - GAP).toDouble()
        drawModes(plotTop, plotHeight.toInt())
        val strokes = panel.lines.map { strokesOf(it.line) }
        val seen = strokes.filter { !it.min.isNaN() }
        val limits = limitsFor(seen.minOfOrNull { it.min } ?: Double.NaN, seen.maxOfOrNull { it.max } ?: Double.NaN, includesZero = false)
        val y = Scale.ofY(limits, plotHeight, plotTop.toDouble())
        val yTicks = Ticks.ofY(limits, plotHeight)
        stroke = BasicStroke(1f)
        color = colorOf(Shade.GRID)
        val x = Scale.ofX(range, plotWidth.toDouble(), LEFT.toDouble())
        for (value in xTicks.values) draw(Line2D.Double(x.placeOf(value), plotTop.toDouble(), x.placeOf(value), plotTop + plotHeight))
        for (value in yTicks.values) draw(Line2D.Double(LEFT.toDouble(), y.placeOf(value), LEFT + plotWidth.toDouble(), y.placeOf(value)))
        yTicks.texts.forEachIndexed { i, text -> textBefore(text, LEFT - 6.0, y.placeOf(yTicks.values[i]) + LETTERS / 3.0) }
        val clipped = clip
        clip = Rectangle(LEFT, plotTop, plotWidth, plotHeight.toInt())
        panel.lines.zip(strokes) { line, drawn ->
            drawn.place(y)
            drawLine(drawn, line.color)
        }
        clip = clipped
        color = colorOf(Shade.BORDER)
        drawRect(LEFT, plotTop, plotWidth, plotHeight.toInt())
        drawLegend(panel, top)
    }

    private fun strokesOf(line: GraphSeries): Strokes {
        val curve = Curve(line.data, view.xAxis.range?.endInclusive?.takeIf { line.holds })
        curve.draw(range.from, range.to, PixelColumns(plotWidth))
        return Strokes().apply { trace(curve, Scale.ofX(range, plotWidth.toDouble(), LEFT.toDouble()), Scale.NONE) }
    }

    private fun Graphics2D.drawLine(strokes: Strokes, rgb: Int) {
        color = Color(rgb)
        stroke = BasicStroke(if (strokes.isDense) 1.2f else 1.6f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND)
        for (i in 0 until strokes.count) {
            val path = Path2D.Double()
            val start = strokes.startOf(i)
            path.moveTo(strokes.points[start], strokes.points[start + 1])
            for (place in start + 2 until strokes.endOf(i) step 2) path.lineTo(strokes.points[place], strokes.points[place + 1])
            draw(path)
        }
        for (place in 0 until strokes.dotsSize step 2) {
            fill(Ellipse2D.Double(strokes.dots[place] - DOT, strokes.dots[place + 1] - DOT, 2 * DOT, 2 * DOT))
        }
    }

    private fun Graphics2D.drawLegend(panel: Panel, top: Int) {
        var left = LEFT.toDouble()
        for (line in panel.lines) {
            val name = withUnit(line.name, if (panel.unit.isEmpty()) "" else "(${panel.unit})")
            val wide = fontMetrics.stringWidth(name)
            if (left + wide + SWATCH > width - RIGHT && left > LEFT) break
            color = Color(line.color)
            fill(Rectangle2D.Double(left, top + LEGEND / 2.0 - 2, SWATCH - 6.0, 4.0))
            text(name, left + SWATCH, top + LEGEND / 2.0 + LETTERS / 3.0, Shade.TEXT, width - RIGHT - left.toInt() - SWATCH)
            left += wide + SWATCH + 16.0
        }
    }

    private fun Graphics2D.drawModes(top: Int, height: Int) {
        val bands = ModeBands().apply { place(ModeTimeline.of(view), range, plotWidth.toDouble()) }
        for (i in 0 until bands.size) {
            val shade = if (bands.modeOf(i) == RobotMode.AUTONOMOUS) Shade.AUTONOMOUS else Shade.TELEOP
            color = Color((shade.of(isDark = false) or (MODE_OPACITY shl 24)), true)
            fill(Rectangle2D.Double(LEFT + bands.leftOf(i), top.toDouble(), bands.rightOf(i) - bands.leftOf(i), height.toDouble()))
        }
    }

    private fun Graphics2D.drawLane(lane: NamedLine, top: Int) {
        val states = lane.line.states.orEmpty()
        val runs = StateRuns(lane.line.data, view.xAxis.range?.endInclusive ?: range.to)
        val blocks = LaneBlocks().apply { place(runs, range, plotWidth.toDouble(), ceil(LaneLook.MIN_BLOCK).toInt()) }
        for (i in 0 until blocks.size) {
            val left = LEFT + blocks.left[i]
            val wide = blocks.right[i] - blocks.left[i]
            val state = blocks.states[i]
            color = colorOf(LaneTone.of(states, state, wide), state)
            fill(Rectangle2D.Double(left, top.toDouble(), wide, LANE - 4.0))
            val room = (wide - 2 * LaneLook.MARGIN).toInt()
            val name = states.getOrElse(state) { "?" }.take(MAX_LETTERS)
            if (room > LETTERS && fontMetrics.stringWidth(name) <= room) {
                text(name, left + LaneLook.MARGIN, top + LANE / 2.0 + LETTERS / 3.0 - 2, Shade.STATE_TEXT, room)
            }
        }
        textBefore(lane.name, LEFT - 6.0, top + LANE / 2.0 + LETTERS / 3.0 - 2)
    }

    private fun Graphics2D.drawX(ticks: Ticks, top: Int) {
        val x = Scale.ofX(range, plotWidth.toDouble(), LEFT.toDouble())
        ticks.texts.forEachIndexed { i, text ->
            val left = x.placeOf(ticks.values[i]) - fontMetrics.stringWidth(text) / 2.0
            text(text, left, top + LETTERS + 2.0, Shade.MUTED, width)
        }
        val name = view.xAxis.title.take(MAX_LETTERS)
        text(name, LEFT + (plotWidth - fontMetrics.stringWidth(name)) / 2.0, top + 2 * LETTERS + 6.0, Shade.MUTED, plotWidth)
    }

    private fun Graphics2D.text(text: String, left: Double, baseline: Double, shade: Shade, room: Int) {
        color = colorOf(shade)
        drawString(fitting(text, room), left.toFloat(), baseline.toFloat())
    }

    /** Draws [text] so that it ends at [right]. */
    private fun Graphics2D.textBefore(text: String, right: Double, baseline: Double) {
        val fitting = fitting(text, right.toInt() - 2)
        text(fitting, right - fontMetrics.stringWidth(fitting), baseline, Shade.MUTED, right.toInt())
    }

    private fun Graphics2D.fitting(text: String, room: Int): String {
        if (fontMetrics.stringWidth(text) <= room) return text
        val most = text.indices.lastOrNull { fontMetrics.stringWidth(text.take(it) + "…") <= room } ?: 0
        return text.take(most) + "…"
    }

    private fun colorOf(shade: Shade) = Color(shade.of(isDark = false))

    private fun colorOf(tone: LaneTone, state: Int): Color = when (tone) {
        LaneTone.OFF -> colorOf(Shade.STATE_OFF)
        LaneTone.QUIET -> Color(lineColor(state, isDark = false) or ((stateOpacity(isDark = false) * 255).toInt() shl 24), true)
        LaneTone.STRONG -> Color(lineColor(state, isDark = false))
    }

    private companion object {
        const val LETTERS = 12
        const val MAX_LETTERS = 60
        const val LEFT = 110
        const val RIGHT = 20
        const val TOP = 28
        const val BOTTOM = 2 * LETTERS + 16
        const val PANEL = 220
        const val LEGEND = 24
        const val GAP = 10
        const val LANE = 24
        const val SWATCH = 22
        const val DOT = 2.2
        const val MODE_OPACITY = 18
    }
}
