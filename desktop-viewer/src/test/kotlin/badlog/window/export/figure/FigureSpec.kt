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
import badlog.viewer.shown.cursor.Cursors
import badlog.window.compare.DrawnRecording
import badlog.window.export.armBag
import badlog.window.export.recordingOf
import badlog.window.findings.findingsOf
import badlog.window.graph.sample
import badlog.window.log.OpenRecording
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
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

    test("several recordings have a legend, and colors in their order") {
        val other = recordingOf(armBag(300).replace("\"8\"", "\"9\""))
        val drawn = svg(defaultBoard(arm.view).graphs.take(1), arm.span, arm, other)
        textsIn(drawn) shouldContainAll listOf("Match 8 · Match 9", "Angle Match 8", "Angle Match 9")
        linesIn(drawn).map { it.getAttribute("stroke") } shouldBe listOf("#0b62c4", "#d4501a")
        textsIn(svg(listOf(joint), arm.span, arm, other)) shouldContainAll listOf("Match 8", "Match 9")
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
})

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
