package badlog.viewer.draw.plot

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.pen.SvgPen
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

/** The text of drawn parts of x, and of the bar of x, primitive by primitive. Its letters have a fixed width. */
class RangeDrawingSpec : FunSpec({
    val colors = PenColors.LIGHT
    val frame = PlotFrame(0.0, 0.0, 200.0, 40.0, Span(0.0, 10.0))

    fun drawn(draw: SvgPen.() -> Unit): List<String> = SvgPen({ text, letters, _ -> text.length * letters / 2 }).apply(draw)
        .document(200.0, 40.0, colors[Shade.SURFACE]).trim().removeSuffix("</svg>").split("<").drop(3).map { "<$it" }.filter { it != "</text>" }

    fun finding(vararg spans: Span) = Finding("Brownout", Severity.ERROR, topic = null, "It browned out.", time = 4.0, spans.toList(), spans.size, timeUnit = "s")

    test("a selection is a band between its visible edges") {
        drawn { drawSelection(frame, Span(5.0, 20.0), colors) } shouldContainExactly listOf(
            """<path d="M100 0h100v40h-100z" fill="#0b62c4" fill-opacity="0.16"/>""",
            """<path d="M100 0L100 40" stroke="#0b62c4" fill="none" stroke-linejoin="round" stroke-width="1"/>""",
        )
        drawn { drawSelectedHeights(frame, 10.0, 30.0, colors) } shouldContainExactly listOf(
            """<path d="M0 10h200v20h-200z" fill="#0b62c4" fill-opacity="0.16"/>""",
            """<path d="M0 10L200 10M0 30L200 30" stroke="#0b62c4" fill="none" stroke-linejoin="round" stroke-width="1"/>""",
        )
    }

    test("the time of a finding is shaded between two edges if it lasts, and a moment is one edge") {
        fun edges(finding: Finding) = drawn { drawFinding(frame, finding, colors) }.last().substringAfter("d=\"").substringBefore('"')
        edges(finding(Span(2.0, 4.0))) shouldBe "M80 0L80 40M40 0L40 40"
        edges(finding(Span(2.0, 2.1))) shouldBe "M40 0L40 40"
        edges(finding()) shouldBe "M80 0L80 40"
        drawn { drawFinding(frame, finding(Span(2.0, 4.0), Span(20.0, 30.0)), colors) } shouldHaveSize 2
    }

    test("everything beside the visible part of a log is shaded, and a wide part has handles") {
        val wide = drawn { drawVisible(frame, Span(2.0, 5.0), colors) }
        wide.take(2) shouldContainExactly listOf(
            """<path d="M0 0h40v40h-40z" fill="#f4f5f7" fill-opacity="0.65"/>""",
            """<path d="M100 0h100v40h-100z" fill="#f4f5f7" fill-opacity="0.65"/>""",
        )
        wide.last() shouldBe """<path d="M40 12L40 28M100 12L100 28" stroke="#0b62c4" fill="none" stroke-linejoin="round" stroke-width="4"/>"""
        val narrow = drawn { drawVisible(frame, Span(5.0, 5.01), colors) }
        narrow shouldHaveSize 3
        narrow.first() shouldContain "h97.6"
    }

    test("the numbers of the x axis' bar leave room for the whole title, and a flag stays within the bar") {
        val bar = drawn { drawXBar(frame, "Time (s)", colors) }
        bar.filter { it.startsWith("<text") }.map { it.substringAfter('>') } shouldContainExactly listOf("Time (s)", "0", "5")
        drawn { drawXBar(frame, "Seconds since the robot was started", colors) } shouldContain
            """<text x="200" y="15.35" font-size="11" text-anchor="end" fill="#596477">Seco…rted"""
        val flag = drawn { drawFlag(frame, 9.9, "9.90 s", Shade.ACCENT, colors) }
        flag.last() shouldBe """<text x="161" y="22.85" font-size="11" fill="#ffffff">9.90 s"""
    }
})
