package badlog.window.export.figure

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.recording.CellCounts
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.Severity
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.rules.Finding
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.defaultBoard
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.draw.mark.RobotMode
import badlog.viewer.shown.cursor.Cursors
import badlog.window.compare.DrawnRecording
import badlog.window.export.armBag
import badlog.window.export.recordingOf
import badlog.window.findings.findingsOf
import badlog.window.graph.sample
import badlog.window.log.OpenRecording
import badlog.window.theme.Palette
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import org.w3c.dom.Document
import org.w3c.dom.Element
import java.awt.Color
import java.awt.image.BufferedImage
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO
import javax.xml.parsers.DocumentBuilderFactory
import kotlin.math.abs
import kotlin.math.sin
import io.kotest.matchers.string.shouldContain as shouldContainText

class FigureSpec : FunSpec({
    val options = FigureOptions()
    val arm = recordingOf(armBag(500))
    val joint = BoardGraph(1, "Arm/Both", listOf("Arm/Angle", "Arm/Current", "Arm/Mode"))

    fun build(graphs: List<BoardGraph>, x: Span, vararg recordings: OpenRecording) = FigureBuilder(recordings.map { DrawnRecording(it) }, x, options.width).build(graphs)

    test("it says what it shows: the recording, the graphs, the axes with their units, the states") {
        val texts = textsIn(svgOf(build(defaultBoard(arm.view).graphs, arm.span, arm), options))
        texts shouldContainAll listOf("Match 8", "Arm/Angle", "deg", "Arm/Current", "A", "Time (s)", "hold", "move")
    }

    test("a formula is drawn as any other line") {
        val open = arm.withFormulas(listOf("Arm/Power [W] = Arm/Current * 12"))
        val frame = build(listOf(BoardGraph(1, "Arm/Power", listOf("Arm/Power"))), open.span, open).frames.single()
        frame.yTitle shouldBe "W"
        frame.lines.single().strokes.let { it.endOf(0) / 2 } shouldBe 500
    }

    test("a path is drawn on its field, with axes of its own, of each recording") {
        val path = sample("wrong-turn.bag")
        val figure = build(path.standardGraphs.graphs.take(2), Span(0.0, 12.0), path)
        val frame = figure.frames[0]
        frame.plane?.isField shouldBe true
        frame.lines.map { it.label } shouldBe listOf("Vision/Pose", "Target Pose", "Drive/Pose")
        // What was planned is dashed, as on the screen.
        frame.lines.map { it.isDashed } shouldBe listOf(false, true, false)
        elements(svgOf(figure, options), "path").count { it.hasAttribute("stroke-dasharray") } shouldBeGreaterThan 0
        elements(svgOf(figure, options), "line").count { it.hasAttribute("stroke-dasharray") } shouldBe 1
        // The points are meters again.
        frame.lines[2].strokes.points.take(2).zip(listOf(1.6, 4.0)).all { (drawn, x) -> abs(drawn - x) < 0.02 } shouldBe true
        textsIn(svgOf(figure, options)) shouldContainAll listOf("x (m)", "y (m)", "Path", "Drive/Pose", "Time (s)")
        build(path.standardGraphs.graphs.take(1), Span(0.0, 12.0), path, path).frames.single().lines.size shouldBe 6
        writeFigure(figure, FigureOptions(format = FigureFormat.PNG), Files.createDirectories(Path.of("build", "pictures")).resolve("figure-path.png"))
    }

    test("a path has the picture of its field below it, and the robot, its plan and its modules at the cursors, also in SVG") {
        val folder = tempdir().toPath()
        val image = BufferedImage(200, 100, BufferedImage.TYPE_INT_RGB)
        for (x in 0 until 200) for (y in 0 until 100) image.setRGB(x, y, 0x00FF00)
        ImageIO.write(image, "png", folder.resolve("green.png").toFile())
        folder.resolve("field.json").toFile().writeText(
            """{"field-image":"green.png","field-corners":{"top-left":[0,0],"bottom-right":[200,100]},"field-size":[54,27],"field-unit":"foot"}""",
        )
        val path = OpenRecording.read(Files.copy(sample("wrong-turn.bag").file, folder.resolve("a.bag")))
        fun figure(cursors: Cursors) = FigureBuilder(listOf(DrawnRecording(path)), path.span, options.width, cursors = cursors).build(path.standardGraphs.graphs.take(1))
        val plain = figure(Cursors()).frames.single()
        val shapes = plain.plane!!.shapes.size
        val figure = figure(Cursors(pinned = 9.4, second = 3.0))
        val plane = figure.frames.single().plane!!
        val driven = path.xyPlot(path.standardGraphs.graphs[0].lines)!!.driven!!
        val index = driven.trail.indexAt(9.4)
        val dot = plane.shapes.filter { it.isDot && !it.isRing }.map { it.columns }
        dot.last() shouldBe mapOf("x" to listOf(driven.trail.x[index]), "y" to listOf(driven.trail.y[index]))
        // The robot at the first cursor alone is filled.
        plane.shapes.count { it.isFilled } shouldBe 1
        plane.shapes.size shouldBeGreaterThan shapes + 4
        figure.frames.single().lines.last().label shouldBe "Drive/Pose ${driven.textAt(9.4, isField = true)}"
        plane.labels.single().text shouldContainText "Left the plan at"
        val svg = svgOf(figure, options)
        val drawn = elements(svg, "image").single()
        drawn.attributes.let { all -> List(all.length) { all.item(it).nodeValue } }.count { it.startsWith("data:image/png;base64,iVBOR") } shouldBe 1
        textsIn(svg).any { "Left the plan at" in it } shouldBe true
        val picture = imageOf(svg, options.width, 1)
        val greens = (0 until picture.width).sumOf { x -> (0 until picture.height).count { y -> Color(picture.getRGB(x, y)).run { green > 200 && red < 160 && blue < 160 } } }
        greens shouldBeGreaterThan 100_000
        writeFigure(figure, FigureOptions(format = FigureFormat.PNG), Files.createDirectories(Path.of("build", "pictures")).resolve("figure-field.png"))
    }

    test("an XY plot of volts over amperes has the line of best fit and the resistance it says") {
        val match = sample("qualification-42.bag")
        val graph = BoardGraph(1, "Battery", listOf("PDP/Total Current", "System/Battery Voltage"), isXy = true)
        val plane = FigureBuilder(listOf(DrawnRecording(match)), match.span, options.width).build(listOf(graph)).frames.single().plane!!
        plane.labels.single().text shouldContainText "mΩ"
        plane.shapes.single().columns.getValue("x") shouldBe listOf(plane.x.from, plane.x.to)
    }

    test("each unit of a graph has a frame of its own, and so have its states") {
        val frames = build(listOf(joint), arm.span, arm).frames
        frames.map { it.yTitle } shouldBe listOf("deg", "A", "")
        frames.map { it.title } shouldBe listOf("Arm/Both", "Current", "Mode")
        frames[2].lanes.single().label shouldBe "Mode"
    }

    test("several recordings are distinguished by a legend, and by colors in the order of the recordings") {
        val other = recordingOf(armBag(300).replace("\"8\"", "\"9\""))
        val figure = build(defaultBoard(arm.view).graphs, arm.span, arm, other)
        figure.title shouldBe "Match 8 · Match 9"
        val colors = listOf(hexOf(Palette.LIGHT.line(0)), hexOf(Palette.LIGHT.line(1)))
        figure.frames[0].legend shouldBe listOf("Match 8", "Match 9").zip(colors)
        val texts = textsIn(svgOf(figure, options))
        texts.count { it == "Match\u00a09" } shouldBe 1
        figure.frames.last().lanes.map { it.label } shouldBe listOf("Match 8", "Match 9")
    }

    test("a recording is drawn where its offset puts it") {
        val moved = FigureBuilder(listOf(DrawnRecording(arm), DrawnRecording(arm, 100.0)), Span(0.0, 200.0), 900).build(listOf(joint))
        moved.frames[0].lines[1].strokes.points[0] shouldBe 100.0
    }

    test("a gap stays a gap, and a sample alone between two gaps is a dot") {
        val gappy = recordingOf(armBag(100) { if (it in 40..59 && it != 50) "" else it.toString() })
        val line = build(listOf(joint), gappy.span, gappy).frames[0].lines[0]
        List(line.strokes.count) { (line.strokes.endOf(it) - line.strokes.startOf(it)) / 2 } shouldBe listOf(40, 1, 40)
        LinePoints(build(listOf(joint), gappy.span, gappy).frames[0]).dots.getValue("y") shouldContain 50.0
    }

    test("y is as on the screen: what is seen and what the attributes want, or what a person has selected") {
        build(defaultBoard(arm.view).graphs, Span(0.2, 0.4), arm).frames[0].y.from shouldBe 0.0
        build(listOf(joint.copy(yRange = Span(-3.0, 4.0))), arm.span, arm).frames[0].y shouldBe Span(-3.0, 4.0)
    }

    test("a line that is hidden on the screen is not drawn, and the others keep their colors") {
        val line = build(listOf(joint.copy(hidden = setOf("Arm/Angle", "Arm/Mode"))), arm.span, arm).frames.single().lines.single()
        line.label shouldBe "Current"
        line.color shouldBe hexOf(Palette.LIGHT.line(1))
    }

    test("what a recording lacks is left out, and a graph without a line has no frame") {
        val absent = BoardGraph(2, "Gone", listOf("Gone"))
        build(listOf(absent, joint.copy(lines = joint.lines + "Gone")), arm.span, arm).frames.map { it.lines.size } shouldBe
            listOf(1, 1, 0)
        build(listOf(absent), arm.span, arm).frames.shouldBeEmpty()
    }

    test("twenty lines of a million samples each are less than two megabytes") {
        val samples = 1_000_000
        val topics = List(20) { topicOf("Noise $it", DoubleArray(samples) { i -> sin(i * (1.7 + it)) }) }
        val long = OpenRecording(Path.of("long.bag").toAbsolutePath(), LogView.of(recordingOf(topics, samples)))
        val graphs = topics.chunked(4).mapIndexed { i, four -> BoardGraph(i, "Noise", four.map { it.name }) }
        val svg = svgOf(build(graphs, long.span, long), options)
        svg.length shouldBeLessThan 2_000_000
        pathsIn(svg) shouldBeGreaterThan 19
    }

    test("a state that changes at every sample costs no more than the figure's width") {
        val flicker = recordingOf("Index,Mode\n" + (0 until 100_000).joinToString("\n") { "$it,${if (it % 2 == 0) "on it" else "off it"}" })
        svgOf(build(listOf(BoardGraph(1, "Mode", listOf("Mode"))), flicker.span, flicker), options).length shouldBeLessThan 2_000_000
    }

    test("names of any letters and any length make a document that can be read") {
        val name = "<b>&amp; \"é\u0001𝄞" + "x".repeat(500)
        val odd = recordingOf(armBag(20).replace("Arm/Angle", "Odd"), Path.of("a & b <c>.bag").toAbsolutePath())
        val figure = build(listOf(BoardGraph(1, name, listOf("Odd", "Arm/Current"))), odd.span, odd)
        val texts = textsIn(svgOf(figure, options))
        texts.count { it.startsWith("<b>&amp; \"é 𝄞xxx") && it.length < 120 } shouldBe 1
        val link = BoardGraph(2, "<a href=\"javascript:alert(1)\">x</a>", listOf("Odd"))
        elements(svgOf(build(listOf(link), odd.span, odd), options), "a").shouldBeEmpty()
        plainLine(name, 10) shouldBe "<b>&a…xxxx"
    }

    test("a recording of one row, and one whose x goes backwards, are drawn too") {
        val one = recordingOf(armBag(1))
        val dot = build(defaultBoard(one.view).graphs, one.span, one)
        dot.frames.first().lines.single().strokes.dotsSize shouldBe 2
        textsIn(svgOf(dot, options)) shouldContain "Arm/Angle"
        val back = recordingOf("Time,A\n1,2\n2,3\n0,4\n1,5\n")
        val line = build(listOf(BoardGraph(1, "A", listOf("A"))), Span(0.0, 2.0), back)
        line.frames.single().lines.single().strokes.let { it.endOf(it.count - 1) } shouldBeGreaterThan 2
        textsIn(svgOf(line, options)) shouldContain "A"
    }

    test("it shows when the robot was enabled, what happened, and what rules found") {
        val match = sample("qualification-42.bag")
        val list = findingsOf(match.logged, match.file, null)
        val figure = FigureBuilder(listOf(DrawnRecording(match)), match.span, options.width, match.events, list.timeline)
            .build(listOf(BoardGraph(1, "Voltage", listOf("System/Battery Voltage"))))
        figure.marks.bands.map { it.color }.distinct() shouldBe
            listOf(RobotMode.AUTONOMOUS, RobotMode.TELEOP).map { hexOf(Palette.LIGHT.mode(it)) }
        figure.marks.bands.forEach { (it.from >= match.span.from && it.to <= match.span.to) shouldBe true }
        figure.marks.events.size shouldBeGreaterThan 3
        figure.marks.findings.size shouldBeGreaterThan 1
        val svg = svgOf(figure, options)
        val error = hexOf(Palette.LIGHT.error)
        (svg.contains("rgb(179,38,30)") || svg.contains(error)) shouldBe true
        Files.createDirectories(Path.of("build/pictures"))
        ImageIO.write(imageOf(svg, options.width, 1), "png", Path.of("build/pictures/figure-marks.png").toFile())
    }

    test("it has the limits of y that the screen has: those of the right axis, and those that graphs share") {
        val both = joint.copy(rightYRange = Span(-7.0, 77.0))
        build(listOf(both), arm.span, arm).frames[1].y shouldBe Span(-7.0, 77.0)
        val angle = BoardGraph(2, "Arm/Angle", listOf("Arm/Angle"), sharesY = true)
        val other = BoardGraph(3, "Twice", listOf("Twice"), sharesY = true)
        val open = arm.withFormulas(listOf("Twice [deg] = Arm/Angle * 2"))
        val frames = build(listOf(angle, other), open.span, open).frames
        frames[0].y shouldBe frames[1].y
        val alone = FigureBuilder(listOf(DrawnRecording(open)), open.span, 900, board = listOf(angle, other)).build(listOf(angle))
        alone.frames.single().y shouldBe frames[0].y
        (build(listOf(angle.copy(sharesY = false)), open.span, open).frames.single().y == frames[0].y) shouldBe false
    }

    test("it explains itself: the file, the visible range, the values at the cursor, and what was found by name") {
        val match = sample("qualification-42.bag")
        val list = findingsOf(match.logged, match.file, null)
        val figure = FigureBuilder(
            listOf(DrawnRecording(match)),
            Span(90.0, 100.0),
            options.width,
            match.events,
            list.timeline,
            cursors = Cursors(pinned = 93.7),
        ).build(listOf(BoardGraph(1, "Voltage", listOf("System/Battery Voltage")), BoardGraph(2, "Modes", listOf("System/Enabled"))))
        figure.marks.cursors shouldBe listOf(93.7)
        figure.frames[0].lines.single().label shouldBe "Battery Voltage 6.73"
        figure.frames[1].lanes.single().label shouldBe "Enabled true"
        val svg = svgOf(figure, options)
        val texts = textsIn(svg)
        texts.count { it.startsWith("qualification-42.bag · 90.000 – 100.000 s · cursor at 93.700 s · Teleop 1:31") } shouldBe 1
        texts.count { it.startsWith("error · 93.710 s") && "The roboRIO browned out" in it } shouldBe 1
        writeFigure(figure, FigureOptions(format = FigureFormat.PNG), Files.createDirectories(Path.of("build", "pictures")).resolve("figure-notes.png"))
    }

    test("what a rule says is text in a figure, whatever signs it has") {
        val found = Finding("<a href=''>", Severity.ERROR, null, "x < y && z", 1.0, emptyList(), 1, "s")
        val timeline = FindingTimeline(listOf(found), { it.severity }, { it.places })
        val figure = FigureBuilder(listOf(DrawnRecording(arm)), arm.span, options.width, findings = timeline).build(listOf(joint))
        textsIn(svgOf(figure, options)).count { it.endsWith("<a href=''>: x < y && z") } shouldBe 1
    }

    test("it has a line where a person wrote a note") {
        val figure = FigureBuilder(listOf(DrawnRecording(arm)), Span(1.0, 5.0), 900, notes = listOf(0.5, 2.0)).build(listOf(joint))
        figure.marks.notes shouldBe listOf(2.0)
        svgOf(figure, options) shouldNotBe svgOf(build(listOf(joint), Span(1.0, 5.0), arm), options)
    }

    test("the picture has the colors of the lines, on white, at twice the size") {
        val svg = svgOf(build(listOf(joint), arm.span, arm), options)
        val image = imageOf(svg, options.width, PICTURE_SCALE)
        image.width shouldBe options.width * 2
        val colors = image.getRGB(0, 0, image.width, image.height, null, 0, image.width).map { it and 0xFFFFFF }.groupingBy { it }.eachCount()
        colors.getValue(0xFFFFFF) shouldBeGreaterThan image.width * image.height / 2
        colors.getValue(0x0B62C4) shouldBeGreaterThan 1000
        colors.getValue(0xD4501A) shouldBeGreaterThan 1000
    }

    test("one line under its own name needs no legend") {
        val frames = build(defaultBoard(arm.view).graphs, arm.span, arm).frames
        frames.filter { it.hasLegend } shouldHaveSize 0
        textsIn(svgOf(build(defaultBoard(arm.view).graphs, arm.span, arm), options)) shouldNotContain "Angle"
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

private fun pathsIn(svg: String) = elements(svg, "path").count { it.getAttribute("d").length > 200 }
