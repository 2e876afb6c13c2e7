package badlog.viewer.draw.plot

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.axis.AxisSide
import badlog.viewer.draw.axis.SeenOfUnit
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.pen.SvgPen
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe

class PlotOfGraphSpec : FunSpec({
    val frame = PlotFrame(0.0, 0.0, 100.0, 72.0, Span(0.0, 10.0))

    class Line(override val series: GraphSeries, override val color: Int, override val offset: Double) : GraphLine {
        val strokes = Strokes().apply {
            val curve = Curve(series.data)
            curve.draw(frame.shown.from - offset, frame.shown.to - offset, PixelColumns(100))
            trace(curve, Scale.ofX(Span(frame.shown.from - offset, frame.shown.to - offset), frame.width), Scale.NONE)
        }
    }

    /** A line in [unit] from 0 to [most] in the first ten seconds. */
    fun line(unit: String, most: Double, color: Int = 0, offset: Double = 0.0): Line {
        val view = timedView(timedTopic("Line", 0.0 to 0.0, 5.0 to most / 2, 10.0 to most).copy(unit = unit))
        return Line(view.seriesOf(view.recording.topics[0]), color, offset)
    }

    fun plot(look: BoardGraph, vararg lines: Line, lanes: Int = 0, shared: Map<String, SeenOfUnit> = emptyMap()): Plot {
        val empty = List(lanes) { PlotLane("Lane", emptyList(), null) }
        return plotOf(look, lines.toList(), lines.map { it.strokes }, empty, frame, density = 1.0, shared)
    }

    val look = BoardGraph(1, "Graph", emptyList())

    test("lines of one unit share an axis that fits them, and the second unit has its own on the right") {
        val made = plot(look, line("V", 10.0, color = 3), line("A", 1000.0, color = 4), line("V", 20.0, color = 5))
        made.axes.map { it.side to it.unit } shouldBe listOf(AxisSide.LEFT to "V", AxisSide.RIGHT to "A")
        made.lines.map { it.axis } shouldBe listOf(0, 1, 0)
        made.lines.map { it.color } shouldBe listOf(3, 4, 5)
        made.axes.map { it.color } shouldBe listOf(null, 4)
        made.axes[0].shown.run { from == 0.0 && to in 20.0..25.0 } shouldBe true
        made.lines[2].strokes.points[1] shouldBe (72.0 plusOrMinus 1e-9)
    }

    test("a selected part of y is shown, and the other axis shows the same part of its own range") {
        val whole = plot(look, line("V", 10.0), line("A", 1000.0))
        val half = whole.axes[0].shown.run { Span(from, from + width / 2) }
        val lower = plot(look.copy(yRange = half), line("V", 10.0), line("A", 1000.0))
        lower.axes[0].shown shouldBe half
        lower.axes[1].shown.to shouldBe (whole.axes[1].shown.run { from + width / 2 } plusOrMinus 1e-9)
    }

    test("graphs with shared limits fit the visible samples of all of them, unit by unit") {
        val seen = mapOf("V" to SeenOfUnit("V", -100.0, 100.0))
        val made = plot(look, line("V", 10.0), line("A", 1000.0), shared = seen)
        made.axes[0].shown.run { from < -100 && to > 100 } shouldBe true
        made.axes[1].shown.from shouldBe 0.0
    }

    test("lanes take their height below lines, at most half, and all of it without lines") {
        plot(look, line("V", 10.0), lanes = 1).laneShare shouldBe 0.25
        plot(look, line("V", 10.0), lanes = 5).laneShare shouldBe 0.5
        plot(look, lanes = 1).laneShare shouldBe 1.0
        plot(look).laneShare shouldBe 0.0
        val strokes = plot(look.copy(yRange = Span(0.0, 10.0)), line("V", 10.0), lanes = 1).lines.single().strokes
        strokes.points[1] shouldBe (54.0 plusOrMinus 1e-9)
    }

    test("the cursor's dot is on the line, moves with it, and is never outside the frame") {
        val one = line("V", 10.0)
        val late = line("V", 10.0, offset = 2.0)
        val made = plot(look.copy(yRange = Span(0.0, 10.0)), one, late)
        made.dotAt(0, one, 5.0, frame) shouldBe (50.0 to 36.0)
        val (x, y) = made.dotAt(1, late, 7.0, frame).shouldNotBeNull()
        x shouldBe (70.0 plusOrMinus 1e-9)
        y shouldBe (36.0 plusOrMinus 1e-9)
        val narrow = plot(look.copy(yRange = Span(0.0, 4.0)), one)
        narrow.dotAt(0, one, 5.0, frame).shouldBeNull()
        fun paths(cursor: Double) = SvgPen({ text, letters, _ -> text.length * letters / 2 })
            .apply { drawSamples(frame, made, listOf(one, late), cursor, PenColors.LIGHT) }
            .document(100.0, 72.0, PenColors.LIGHT[Shade.SURFACE]).split("<path").size
        // Each dot is on top of a larger one in the color of the background.
        paths(7.0) - paths(11.0) shouldBe 4
        paths(1.0) - paths(11.0) shouldBe 2
    }
})
