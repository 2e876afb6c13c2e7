package badlog.viewer.draw.plot

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.StateRuns
import badlog.core.recording.Severity
import badlog.viewer.bagView
import badlog.viewer.draw.axis.AxisSide
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.lane.LaneBlocks
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.draw.mark.ModeSpan
import badlog.viewer.draw.mark.ModeTimeline
import badlog.viewer.draw.mark.RobotMode
import badlog.viewer.draw.pen.SvgPen
import badlog.viewer.shown.cursor.Cursors
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith

/** The text of a drawn plot, primitive by primitive, with letters of a fixed width. */
class PlotDrawingSpec : FunSpec({
    val colors = PenColors.LIGHT
    val frame = PlotMargins.frameOf(width = 276, height = 132, Span(0.0, 10.0), density = 1.0)

    fun drawn(draw: SvgPen.() -> Unit): List<String> = SvgPen({ text, letters, _ -> text.length * letters / 2 }).apply(draw)
        .document(276.0, 132.0, colors[Shade.SURFACE]).trim().removeSuffix("</svg>").split("<").drop(3).map { "<$it" }.filter { it != "</text>" }

    fun line(color: Int, axis: Int, limits: Span, vararg y: Double): PlotLine {
        val curve = Curve(Series(DoubleArray(y.size) { it * 5.0 }, y), holdsUntil = null).apply { draw(0.0, 10.0, PixelColumns(200)) }
        return PlotLine(color, Strokes().apply { trace(curve, frame.x, frame.scaleOf(limits)) }, axis)
    }

    val noMarks = PlotMarks(ModeTimeline.of(bagView(listOf("A"), listOf("1"))), EventTimeline.NONE, findings = null, notes = emptyList())

    test("a line has its axis, a grid, and the numbers of both axes, with the unit at the top") {
        val limits = Span(0.0, 2.0)
        val plot = Plot(listOf(PlotAxis(AxisSide.LEFT, "V", limits, color = null)), listOf(line(0, 0, limits, 0.0, 2.0, 1.0)), emptyList(), 0.0)
        drawn { drawPlot(frame, plot, noMarks, colors, PlotMargins.BOTTOM.toDouble()) } shouldBe listOf(
            """<path d="M62.5 6L62.5 106M162.5 6L162.5 106M262.5 6L262.5 106M62 106.5L262 106.5M62 81.5L262 81.5M62 56.5L262 56.5M62 31.5L262 31.5M62 6.5L262 6.5" stroke="#e9ecf0" fill="none" stroke-linejoin="round" stroke-width="1"/>""",
            """<text x="62" y="121.35" font-size="11" text-anchor="middle" fill="#596477">0""",
            """<text x="162" y="121.35" font-size="11" text-anchor="middle" fill="#596477">5""",
            """<text x="262" y="121.35" font-size="11" text-anchor="middle" fill="#596477">10""",
            """<clipPath id="cut1">""",
            """<path d="M62 4.5h200v103h-200z"/>""",
            """</clipPath>""",
            """<path d="M62 106L162 6L262 56" stroke="#0b62c4" fill="none" stroke-linejoin="round" stroke-width="1.5" clip-path="url(#cut1)"/>""",
            """<path d="M64.5 106a2.5 2.5 0 1 0 -5 0a2.5 2.5 0 1 0 5 0M164.5 6a2.5 2.5 0 1 0 -5 0a2.5 2.5 0 1 0 5 0M264.5 56a2.5 2.5 0 1 0 -5 0a2.5 2.5 0 1 0 5 0" fill="#0b62c4"/>""",
            """<text x="56" y="104.35" font-size="11" text-anchor="end" fill="#596477">0.0""",
            """<text x="56" y="84.85" font-size="11" text-anchor="end" fill="#596477">0.5""",
            """<text x="56" y="59.85" font-size="11" text-anchor="end" fill="#596477">1.0""",
            """<text x="56" y="34.85" font-size="11" text-anchor="end" fill="#596477">1.5""",
            """<text x="56" y="15.35" font-size="11" text-anchor="end" fill="#596477">2.0 V""",
        )
    }

    test("lanes have their states' names where they fit, and their own names beside them if there are several") {
        val runs = StateRuns(Series(doubleArrayOf(0.0, 5.0), doubleArrayOf(0.0, 1.0)), end = 10.0)
        val blocks = LaneBlocks().apply { place(runs, frame.shown, frame.width, density = 1.0) }
        val lane = PlotLane("Intake/Deployed", listOf("false", "true"), blocks)
        val plot = Plot(emptyList(), emptyList(), listOf(lane, PlotLane("Hidden", listOf("a"), null)), laneShare = 1.0)
        drawn { drawPlot(frame, plot, noMarks, colors, 0.0) }.filterNot { "e9ecf0" in it } shouldBe listOf(
            """<clipPath id="cut1">""",
            """<path d="M62 6h200v100h-200z"/>""",
            """</clipPath>""",
            """<path d="M62 6h100v48h-100z" fill="#e4e8ed" clip-path="url(#cut1)"/>""",
            """<text x="67" y="33.85" font-size="11" fill="#1b2330" clip-path="url(#cut1)">false""",
            """<path d="M162 6h100v48h-100z" fill="#f0c2af" clip-path="url(#cut1)"/>""",
            """<text x="167" y="33.85" font-size="11" fill="#1b2330" clip-path="url(#cut1)">true""",
            """<text x="57" y="34.85" font-size="11" text-anchor="end" fill="#596477">Inta…oyed""",
            """<text x="57" y="84.85" font-size="11" text-anchor="end" fill="#596477">Hidden""",
        )
    }

    test("an area is filled between its line and 0") {
        val limits = Span(-1.0, 1.0)
        val plot = Plot(listOf(PlotAxis(AxisSide.LEFT, "V", limits, color = null)), listOf(line(0, 0, limits, 1.0, 0.5, 1.0)), emptyList(), 0.0, isFilled = true)
        drawn { drawPlot(frame, plot, noMarks, colors, 0.0) }.single { "fill-opacity" in it } shouldBe
            """<path d="M62 6L162 31L262 6L262 56L62 56z" fill="#0b62c4" fill-opacity="0.19" clip-path="url(#cut1)"/>"""
    }

    test("the robot’s modes are shaded below lines and above lanes, which would hide them") {
        val marks = PlotMarks(ModeTimeline(listOf(ModeSpan(Span(0.0, 5.0), RobotMode.TELEOP)), 1.0), EventTimeline.NONE, findings = null, notes = emptyList())
        val limits = Span(0.0, 2.0)
        val lines = Plot(listOf(PlotAxis(AxisSide.LEFT, "V", limits, color = null)), listOf(line(0, 0, limits, 1.0, 2.0)), emptyList(), 0.0)
        val lanes = Plot(emptyList(), emptyList(), listOf(PlotLane("Intake", listOf("a"), null)), laneShare = 1.0)
        drawn { drawPlot(frame, lines, marks, colors, 0.0) }.first() shouldStartWith """<path d="M62 6h100v100h-100z" fill="""
        drawn { drawPlot(frame, lanes, marks, colors, 0.0) }.last() shouldStartWith """<path d="M62 6h100v100h-100z" fill="""
    }

    test("an event has a head and a line, or in a crowd a tick, and an error keeps both, with a stronger line") {
        val rows = listOf("2,auto", "5,chatter", "5.125,ERROR: brownout", "5.25,chatter")
        val events = EventTimeline.of(bagView(listOf("Time|xaxis", "Log|log"), rows).folders.flatMap { it.eventLogs })
        val line = "fill=\"none\" stroke-linejoin=\"round\" stroke-width=\"1\"/>"
        drawn { drawEventMarks(frame, events, colors) } shouldBe listOf(
            """<path d="M102.5 6L102.5 106" stroke="#a84300" stroke-opacity="0.2" $line""",
            """<path d="M164.5 6L164.5 106" stroke="#a84300" stroke-opacity="0.5" $line""",
            """<path d="M162.5 6L162.5 9.5M167.5 6L167.5 9.5" stroke="#a84300" stroke-opacity="0.5" $line""",
            """<path d="M99 6L106 6L102.5 11.25zM161 6L168 6L164.5 11.25z" fill="#a84300"/>""",
        )
    }

    test("findings, notes and cursors have marks of their own") {
        val findings = FindingTimeline(listOf(Span(2.0, 4.0)), { Severity.ERROR }, { listOf(it) })
        drawn {
            drawFindingMarks(frame, findings, colors)
            drawNoteMarks(frame, listOf(5.0, 99.0), colors)
            drawCursors(frame, Cursors(pinned = 1.0, second = 3.0, hover = 20.0), colors)
        } shouldBe listOf(
            """<path d="M102 6h41v100h-41z" fill="#b3261e" fill-opacity="0.13"/>""",
            """<path d="M102 103h41v3h-41z" fill="#b3261e"/>""",
            """<path d="M102 6L102 106" stroke="#b3261e" stroke-opacity="0.6" fill="none" stroke-linejoin="round" stroke-width="1" stroke-dasharray="3"/>""",
            """<path d="M102 96L106.5 100.5L102 105L97.5 100.5z" fill="#b3261e"/>""",
            """<path d="M102 96L106.5 100.5L102 105L97.5 100.5z" stroke="#ffffff" fill="none" stroke-linejoin="round" stroke-width="1"/>""",
            """<path d="M162 6h1v100h-1z" fill="#0b62c4"/>""",
            """<path d="M162 6h9v6h-9z" fill="#0b62c4"/>""",
            """<path d="M82 6L82 106" stroke="#0b62c4" fill="none" stroke-linejoin="round" stroke-width="2"/>""",
            """<path d="M122 6L122 106" stroke="#0b62c4" fill="none" stroke-linejoin="round" stroke-width="2" stroke-dasharray="4"/>""",
        )
    }
})
