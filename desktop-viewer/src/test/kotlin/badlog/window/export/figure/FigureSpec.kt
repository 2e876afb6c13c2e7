package badlog.window.export.figure

import androidx.compose.ui.graphics.toAwtImage
import androidx.compose.ui.graphics.toComposeImageBitmap
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.recording.CellCounts
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.defaultBoard
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.cssColor
import badlog.viewer.shown.cursor.Cursors
import badlog.window.compare.DrawnRecording
import badlog.window.export.armBag
import badlog.window.export.recordingOf
import badlog.window.findings.findingsOf
import badlog.window.graph.sample
import badlog.window.graph.withFormulas
import badlog.window.log.OpenRecording
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import org.w3c.dom.Document
import org.w3c.dom.Element
import java.awt.Color
import java.awt.image.BufferedImage
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO
import javax.xml.parsers.DocumentBuilderFactory
import kotlin.math.sin

@Tags("InCheck")
class FigureSpec : FunSpec({
    val arm = recordingOf(armBag(500))
    val joint = BoardGraph(1, "Arm/Both", listOf("Arm/Angle", "Arm/Current", "Arm/Mode"))

    fun svg(graphs: List<BoardGraph>, x: Span, vararg recordings: OpenRecording) = svgOf(LogFigure(recordings.map { DrawnRecording(it) }, x), graphs)

    fun picture(name: String, figure: LogFigure, graphs: List<BoardGraph>) = writeFigure(figure, graphs, FigureFormat.PNG, Files.createDirectories(Path.of("build", "pictures")).resolve(name))

    test("a figure shows the recording, the graphs, the axes with their units, and the states") {
        val texts = textsIn(svg(defaultBoard(arm.view).graphs, arm.span, arm))
        texts shouldContainAll listOf("Match 8", "Arm/Angle", "Arm/Current", "Time (s)", "hold", "move")
        texts.any { it.endsWith(" deg") } shouldBe true
        texts.any { it.endsWith(" A") } shouldBe true
    }

    test("a formula is drawn like any other line") {
        val open = arm.withFormulas(listOf("Arm/Power [W] = Arm/Current * 12"))
        val drawn = svg(listOf(BoardGraph(1, "Arm/Power", listOf("Arm/Power"))), open.span, open)
        textsIn(drawn).any { it.endsWith(" W") } shouldBe true
        linesIn(drawn) shouldHaveSize 1
    }

    test("the path of each recording is drawn on its field, with axes of its own; a planned path is dashed") {
        val path = sample("wrong-turn.bag")
        val graphs = path.standardGraphs.graphs.take(2)
        val drawn = svg(graphs, Span(0.0, 12.0), path)
        textsIn(drawn) shouldContainAll listOf("x (m)", "y (m)", "Path", "Drive/Pose", "Target Pose", "Vision/Pose", "Time (s)")
        fun dashed(svg: String) = elements(svg, "path").count { it.hasAttribute("stroke-dasharray") && it.getAttribute("stroke") != EVENT }
        // On a field, the whole path is drawn faintly, and the visible part above it.
        dashed(svg(graphs.take(1), Span(0.0, 12.0), path)) shouldBe 2
        dashed(svg(graphs.take(1), Span(0.0, 12.0), path, path)) shouldBe 4
        picture("figure-path.png", LogFigure(listOf(DrawnRecording(path)), Span(0.0, 12.0)), graphs)
    }

    test("a path is drawn over the picture of its field, with the robot, its plan and its modules at the cursors, also in SVG") {
        val folder = tempdir().toPath()
        val image = BufferedImage(200, 100, BufferedImage.TYPE_INT_RGB)
        for (x in 0 until 200) for (y in 0 until 100) image.setRGB(x, y, 0x00FF00)
        ImageIO.write(image, "png", folder.resolve("green.png").toFile())
        folder.resolve("field.json").toFile().writeText(
            """{"field-image":"green.png","field-corners":{"top-left":[0,0],"bottom-right":[200,100]},"field-size":[54,27],"field-unit":"foot"}""",
        )
        val path = OpenRecording.read(Files.copy(sample("wrong-turn.bag").file, folder.resolve("a.bag")))
        val graphs = path.standardGraphs.graphs.take(1)
        fun figure(cursors: Cursors) = LogFigure(listOf(DrawnRecording(path)), path.span, cursors = cursors)
        fun filled(svg: String) = elements(svg, "path").count { it.getAttribute("fill-opacity") == "0.25" }
        val plain = svgOf(figure(Cursors()), graphs)
        val drawn = svgOf(figure(Cursors(pinned = 9.4, second = 3.0)), graphs)
        val driven = path.paths.plotOf(graphs[0].lines)!!.driven!!
        textsIn(drawn) shouldContain "Drive/Pose ${driven.textAt(9.4, isField = true)}"
        textsIn(drawn).count { it.startsWith("Left the plan at") } shouldBe 1
        // Only the robot at the first cursor is filled.
        filled(drawn) shouldBe filled(plain) + 1
        elements(drawn, "path").size shouldBeGreaterThan elements(plain, "path").size + 4
        elements(drawn, "image").single().getAttribute("xlink:href").startsWith("data:image/png;base64,iVBOR") shouldBe true
        val made = imageOf(figure(Cursors(pinned = 9.4)), graphs, scale = 1).toComposeImageBitmap().toAwtImage()
        val greens = (0 until made.width).sumOf { x -> (0 until made.height).count { y -> Color(made.getRGB(x, y)).run { green > 200 && red < 160 && blue < 160 } } }
        greens shouldBeGreaterThan 100_000
        picture("figure-field.png", figure(Cursors(pinned = 9.4, second = 3.0)), graphs)
    }

    test("an XY plot of volts over amperes shows the resistance") {
        val match = sample("qualification-42.bag")
        val graph = BoardGraph(1, "Battery", listOf("PDP/Total Current", "System/Battery Voltage"), isXy = true)
        textsIn(svg(listOf(graph), match.span, match)).count { "mΩ" in it } shouldBe 1
    }

    test("several recordings have a legend, and colors in their order") {
        val other = recordingOf(armBag(300).replace("\"8\"", "\"9\""))
        val drawn = svg(defaultBoard(arm.view).graphs.take(1), arm.span, arm, other)
        textsIn(drawn) shouldContainAll listOf("Match 8 · Match 9", "Angle Match 8", "Angle Match 9")
        linesIn(drawn).map { it.getAttribute("stroke") } shouldBe listOf("#0b62c4", "#d4501a")
        textsIn(svg(listOf(joint), arm.span, arm, other)) shouldContainAll listOf("Match 8", "Match 9")
    }

    test("a recording is drawn at its offset") {
        val figure = LogFigure(listOf(DrawnRecording(arm), DrawnRecording(arm, 100.0)), Span(0.0, 200.0))
        val (first, moved) = linesIn(svgOf(figure, listOf(joint.copy(lines = listOf("Arm/Angle"))))).map { startOf(it) }
        // Half of the frame's width: 900 points without its margins.
        moved - first shouldBe ((900 - 62 - 14) / 2.0 plusOrMinus 1.0)
    }

    test("y is as on the screen: selected limits of both axes, and shared limits") {
        fun numbers(graph: BoardGraph, board: List<BoardGraph> = emptyList(), open: OpenRecording = arm) = textsIn(svgOf(LogFigure(listOf(DrawnRecording(open)), open.span, board = board), listOf(graph)))
        numbers(joint.copy(yRange = Span(-3.0, 4.0))) shouldContainAll listOf("-2", "0", "4 deg")
        numbers(joint.copy(rightYRange = Span(-7.0, 77.0))) shouldContain "60 A"
        val angle = BoardGraph(2, "Arm/Angle", listOf("Arm/Angle"), sharesY = true)
        val other = BoardGraph(3, "Twice", listOf("Twice"), sharesY = true)
        val open = arm.withFormulas(listOf("Twice [deg] = Arm/Angle * 2"))
        val shared = numbers(angle, listOf(angle, other), open).filter { it.endsWith(" deg") }
        shared shouldBe numbers(other, listOf(angle, other), open).filter { it.endsWith(" deg") }
        shared shouldNotBe numbers(angle.copy(sharesY = false), emptyList(), open).filter { it.endsWith(" deg") }
    }

    test("graphs of one title have the numbered titles of the screen") {
        val again = joint.copy(id = 2, lines = listOf("Arm/Current"))
        val figure = LogFigure(listOf(DrawnRecording(arm)), arm.span, board = listOf(joint, again))
        textsIn(svgOf(figure, listOf(joint, again))) shouldContainAll listOf(joint.title, "${joint.title} (2)")
        textsIn(svgOf(figure, listOf(again))) shouldContain "${joint.title} (2)"
    }

    test("a line that is hidden on the screen is not drawn, and the others keep their colors") {
        val drawn = svg(listOf(joint.copy(hidden = setOf("Arm/Angle", "Arm/Mode"))), arm.span, arm)
        linesIn(drawn).single().getAttribute("stroke") shouldBe "#d4501a"
        textsIn(drawn) shouldContain "Current"
    }

    test("missing topics are left out, and a figure without lines is not written") {
        val absent = BoardGraph(2, "Gone", listOf("Gone"))
        val figure = LogFigure(listOf(DrawnRecording(arm)), arm.span)
        figure.drawable(listOf(absent, joint.copy(lines = joint.lines + "Gone"))).map { it.id } shouldBe listOf(1)
        val file = tempdir().toPath().resolve("nothing.svg")
        shouldThrow<IOException> { writeFigure(figure, listOf(absent), FigureFormat.SVG, file) }.message shouldBe
            "None of the selected graphs has a line in this log; select others."
        Files.exists(file) shouldBe false
    }

    test("twenty lines of a hundred thousand samples each are less than two megabytes") {
        val samples = 100_000
        val topics = List(20) { topicOf("Noise $it", DoubleArray(samples) { i -> sin(i * (1.7 + it)) }) }
        val long = OpenRecording(Path.of("long.bag").toAbsolutePath(), LogView.of(recordingOf(topics, samples)))
        val graphs = topics.chunked(4).mapIndexed { i, four -> BoardGraph(i, "Noise", four.map { it.name }) }
        val drawn = svg(graphs, long.span, long)
        drawn.length shouldBeLessThan 2_000_000
        linesIn(drawn) shouldHaveSize 20
    }

    test("names of any letters and any length make a readable document") {
        val name = "<b>&amp; \"é\u0001𝄞" + "x".repeat(500)
        val odd = recordingOf(armBag(20).replace("Arm/Angle", "Odd"), Path.of("a & b <c>.bag").toAbsolutePath())
        val texts = textsIn(svg(listOf(BoardGraph(1, name, listOf("Odd", "Arm/Current"))), odd.span, odd))
        texts.count { it.startsWith("<b>&amp; \"é\uFFFD𝄞xxx") && it.length < 150 } shouldBe 1
        val link = BoardGraph(2, "<a href=\"javascript:alert(1)\">x</a>", listOf("Odd"))
        elements(svg(listOf(link), odd.span, odd), "a").shouldBeEmpty()
    }

    test("a recording of one row, and one with x going backwards, are drawn, too") {
        val one = recordingOf(armBag(1))
        val dot = svg(listOf(BoardGraph(1, "Arm/Angle", listOf("Arm/Angle"))), one.span, one)
        elements(dot, "path").count { it.getAttribute("fill") == "#0b62c4" } shouldBe 1
        textsIn(dot) shouldContain "Arm/Angle"
        val back = recordingOf("Time,A\n1,2\n2,3\n0,4\n1,5\n")
        linesIn(svg(listOf(BoardGraph(1, "A", listOf("A"))), Span(0.0, 2.0), back)) shouldHaveSize 1
    }

    test("a figure shows the enabled times, events, findings and notes") {
        val match = sample("qualification-42.bag")
        val list = findingsOf(match.logged, match.file, null)
        val graphs = listOf(BoardGraph(1, "Voltage", listOf("System/Battery Voltage")))
        fun figure(notes: List<Double>) = LogFigure(listOf(DrawnRecording(match)), match.span, events = match.events, findings = list.timeline, notes = notes)
        fun count(color: Shade, notes: List<Double> = emptyList()) = elements(svgOf(figure(notes), graphs), "path").count { it.getAttribute("fill") == cssColor(color.of(isDark = false)) }
        count(Shade.AUTONOMOUS) shouldBe 1
        count(Shade.TELEOP) shouldBeGreaterThan 0
        count(Shade.EVENT) shouldBeGreaterThan 0
        count(Shade.ERROR) shouldBeGreaterThan 0
        // The line and the flag of the note.
        count(Shade.ACCENT, listOf(20.0)) - count(Shade.ACCENT) shouldBe 2
        picture("figure-marks.png", figure(listOf(20.0)), graphs)
    }

    test("a figure names its file, its visible range, the values at the cursor, and the findings") {
        val match = sample("qualification-42.bag")
        val list = findingsOf(match.logged, match.file, null)
        val graphs = listOf(BoardGraph(1, "Voltage", listOf("System/Battery Voltage")), BoardGraph(2, "Modes", listOf("System/Enabled")))
        val cursors = Cursors(pinned = 93.7)
        val figure = LogFigure(listOf(DrawnRecording(match)), Span(90.0, 100.0), events = match.events, findings = list.timeline, cursors = cursors)
        val texts = textsIn(svgOf(figure, graphs))
        texts shouldContainAll listOf("Battery Voltage 6.73 V", "Enabled true")
        texts.count { it.startsWith("qualification-42.bag · 90.000 – 100.000 s · cursor at 93.700 s · Teleop 1:31") } shouldBe 1
        texts shouldContain "error · 93.710 s"
        texts.count { "The roboRIO browned out" in it } shouldBe 1
        picture("figure-notes.png", figure, graphs)
    }

    test("the picture has the colors of the lines, on white, at twice the size") {
        val made = imageOf(LogFigure(listOf(DrawnRecording(arm)), arm.span), listOf(joint)).toComposeImageBitmap().toAwtImage()
        made.width shouldBe 900 * 2
        val colors = made.getRGB(0, 0, made.width, made.height, null, 0, made.width).map { it and 0xFFFFFF }.groupingBy { it }.eachCount()
        colors.getValue(0xFFFFFF) shouldBeGreaterThan made.width * made.height / 2
        colors.getValue(0x0B62C4) shouldBeGreaterThan 1000
        colors.getValue(0xD4501A) shouldBeGreaterThan 1000
    }

    test("a single line with the name of its graph needs no legend") {
        textsIn(svg(defaultBoard(arm.view).graphs, arm.span, arm)) shouldNotContain "Angle"
    }
})

private val EVENT = cssColor(Shade.EVENT.of(isDark = false))

private fun topicOf(name: String, samples: DoubleArray) = Topic(name, "V", emptyList(), samples, TextColumn.EMPTY, CellCounts(samples.size, 0, 0, 0, 0, 0))

private fun recordingOf(topics: List<Topic>, rows: Int) = Recording(RecordingFormat.CSV, null, emptyList(), topics, rows, emptyList())

private fun documentOf(svg: String): Document = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(svg.byteInputStream())

private fun elements(svg: String, name: String): List<Element> {
    val nodes = documentOf(svg).getElementsByTagName(name)
    return (0 until nodes.length).map { nodes.item(it) as Element }
}

private fun textsIn(svg: String) = elements(svg, "text").map { it.textContent.trim() }

/** Returns the lines of a log: the only strokes of this width. */
private fun linesIn(svg: String) = elements(svg, "path").filter { it.getAttribute("stroke-width") == "1.5" || it.getAttribute("d").length > 2000 }

/** Returns the x of the first point of a path. */
private fun startOf(path: Element) = path.getAttribute("d").drop(1).substringBefore(' ').toDouble()
