package badlog.window.graph.plot

import badlog.core.analysis.Span
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.axis.AxisSide
import badlog.viewer.draw.plot.PlotLine
import badlog.viewer.text.exactText
import badlog.window.compare.DrawnRecording
import badlog.window.graph.bagOf
import badlog.window.graph.readingOf
import badlog.window.graph.recordingOf
import badlog.window.log.OpenRecording
import badlog.window.theme.Palette
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe

class PictureMakingSpec : FunSpec({
    fun picture(recordings: List<DrawnRecording>, names: List<String>, visible: Span, hidden: Set<String> = emptySet()): PlotPicture {
        val spec = BoardGraph(1, "Graph", names, hidden = hidden)
        return makePicture(PlotRequest(spec, recordings, visible, width = 100, height = 50, Palette.LIGHT, density = 1f), CurveCache())
    }

    fun picture(recording: OpenRecording, visible: Span = recording.span) = picture(listOf(DrawnRecording(recording)), listOf("A/Voltage"), visible)

    test("a hidden line leaves its axis to another one, and the others keep their colors") {
        val names = listOf("A", "B", "C")
        val units = listOf("V", "A", "m")
        val header = names.indices.joinToString(",") { """{"name":"${names[it]}","unit":"${units[it]}","attrs":[]}""" }
        val text = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},$header],"values":[]}""" + "\nTime,A,B,C\n0,0,0,5\n1,10,1000,6\n"
        val made = picture(listOf(DrawnRecording(recordingOf(text))), names, Span(0.0, 1.0), hidden = setOf("A"))
        made.lines.map { it.signal.name } shouldBe listOf("B", "C")
        made.lines.map { it.color } shouldBe listOf(1, 2)
        made.plot.axes.map { it.side to it.unit } shouldBe listOf(AxisSide.LEFT to "A", AxisSide.RIGHT to "m")
    }

    test("the legend has the exact sample, with six digits, and its tooltip with all") {
        val recording = recordingOf(bagOf(101) { 12.34567 + it })
        val made = picture(recording)
        readingOf(made, made.lines.single(), 5.04) shouldBe "62.3457 V"
        readingOf(made, made.lines.single(), 5.06) shouldBe "63.3457 V"
        readingOf(made, made.lines.single(), 0.0) shouldBe "12.3457 V"
        readingOf(made, made.lines.single(), -100.0) shouldBe "–"
        readingOf(made, made.lines.single(), 5.04, sampleText = ::exactText) shouldBe "62.34567 V"
        readingOf(made, made.lines.single(), null) shouldBe ""
    }

    test("another recording is drawn at its offset, in a color of its own") {
        val one = recordingOf(bagOf(11) { it.toDouble() })
        val other = recordingOf(bagOf(11) { it.toDouble() })
        val made = picture(listOf(DrawnRecording(one), DrawnRecording(other, 0.5)), listOf("A/Voltage"), Span(0.0, 1.0))
        made.lines shouldHaveSize 2
        made.lines.map { it.color } shouldBe listOf(0, 1)
        made.plot.lines[1].points.single()[0] shouldBe (50.0 plusOrMinus 1e-3)
        readingOf(made, made.lines[1], 0.7) shouldBe "2 V"
    }

    test("a request without lines makes an empty picture") {
        picture(recordingOf(bagOf(0) { 0.0 })).lines shouldHaveSize 0
        picture(recordingOf(bagOf(1) { 5.0 })).plot.lines.single().points.single().size shouldBe 2
        picture(recordingOf(bagOf(5) { if (it == 2) Double.POSITIVE_INFINITY else Double.NaN })).plot.lines.single().points shouldHaveSize 0
    }
})

/** The strokes' points, x and y in turn. */
private val PlotLine.points: List<DoubleArray>
    get() = List(strokes.count) { strokes.points.copyOfRange(strokes.startOf(it), strokes.endOf(it)) }
