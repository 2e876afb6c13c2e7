package badlog.window.graph.plot

import badlog.catalog.folder.loggedTopic
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
import badlog.window.wpilogRecording
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

    test("a line reaches from edge to edge, with its ends at its samples") {
        val line = picture(recordingOf(bagOf(11) { it.toDouble() })).plot.lines.single()
        val points = line.points.single()
        points.size shouldBe 22
        points[0] shouldBe (0.0 plusOrMinus 1e-3)
        points[20] shouldBe (100.0 plusOrMinus 1e-3)
        (points[1] > points[21]) shouldBe true
    }

    test("a value of a WPILOG holds until the next one and to the end, in steps without dots at their corners") {
        val recording = wpilogRecording(loggedTopic("A/Voltage", 0.0 to 1.0, 5.0 to 3.0), loggedTopic("B", 0.0 to 0.0, 10.0 to 0.0))
        val made = picture(recording)
        val line = made.plot.lines.single()
        line.points.single().filterIndexed { i, _ -> i % 2 == 0 } shouldBe listOf(0.0, 50.0, 50.0, 100.0)
        line.strokes.dots.take(line.strokes.dotsSize).filterIndexed { i, _ -> i % 2 == 0 } shouldBe listOf(0.0, 50.0)
        readingOf(made, made.lines.single(), 4.9) shouldBe "1 V"
        readingOf(made, made.lines.single(), 9.0) shouldBe "3 V"
    }

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

    test("graphs that share their limits show the same range of y, for lines of one unit") {
        val text = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"A","unit":"V","attrs":[]},""" +
            """{"name":"B","unit":"V","attrs":[]},{"name":"C","unit":"A","attrs":[]}],"values":[]}""" + "\nTime,A,B,C\n0,0,5,1\n1,1,100,2\n"
        val recordings = listOf(DrawnRecording(recordingOf(text)))
        val graphs = listOf("A", "B", "C").mapIndexed { i, name -> BoardGraph(i + 1, name, listOf(name), sharesY = true) }
        fun shown(graph: BoardGraph) = makePicture(
            PlotRequest(graph, recordings, Span(0.0, 1.0), 100, 50, Palette.LIGHT, 1f, graphs - graph),
            CurveCache(),
        ).plot.axes.single().shown
        shown(graphs[0]) shouldBe shown(graphs[1])
        (shown(graphs[0]).to > 99) shouldBe true
        (shown(graphs[2]).to < 3) shouldBe true
    }

    test("states are drawn as lanes, below lines or alone") {
        val text = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Gear","unit":"ul","attrs":[]},""" +
            """{"name":"V","unit":"V","attrs":[]}],"values":[]}""" + "\nTime,Gear,V\n0,LOW,1\n1,LOW,2\n2,HIGH,3\n4,HIGH,4\n"
        val recordings = listOf(DrawnRecording(recordingOf(text)))
        val alone = picture(recordings, listOf("Gear"), Span(0.0, 4.0))
        alone.plotHeight shouldBe 0f
        alone.plot.lanes.single().blocks!!.let { blocks -> List(blocks.size) { blocks.left[it] to blocks.right[it] } } shouldBe listOf(0.0 to 50.0, 50.0 to 100.0)
        val mixed = picture(recordings, listOf("Gear", "V"), Span(0.0, 4.0))
        mixed.plotHeight shouldBe 32f
        readingOf(mixed, mixed.lanes.single(), 1.9) shouldBe "LOW"
        readingOf(mixed, mixed.lines.single(), 1.9) shouldBe "3 V"
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

    test("an x with the widest possible range is not drawn, and does not fail") {
        picture(recordingOf(bagOf(5) { 1.0 }), Span(-1e308, 1e308)).lines shouldHaveSize 0
    }
})

/** The strokes' points, x and y in turn. */
private val PlotLine.points: List<DoubleArray>
    get() = List(strokes.count) { strokes.points.copyOfRange(strokes.startOf(it), strokes.endOf(it)) }
