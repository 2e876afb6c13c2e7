package badlog.window.choice

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.window.bagOf
import badlog.window.export.recordingOf
import badlog.window.graph.choosing
import badlog.window.graph.viewerOf
import badlog.window.graph.withFormulas
import badlog.window.log.OpenRecording
import badlog.window.log.RecordingChoices
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import java.nio.file.Files

class AxisChoiceSpec : FunSpec({
    val text = bagOf(listOf("Time", "Arm/Angle"), List(20) { "${10 + it * 0.5},$it" })

    test("a bag without an x axis is drawn over its time on request, and over its rows again") {
        val viewer = viewerOf(recordingOf(text))
        choosing(viewer) { viewer.axis.choose(true) }
        viewer.view.viewport.full shouldBe Span(10.0, 19.5)
        viewer.board.state.graphs.map { it.lines } shouldBe listOf(listOf("Arm/Angle"))
        choosing(viewer) { viewer.axis.choose(false) }
        viewer.view.viewport.full shouldBe Span(0.0, 19.0)
        viewer.board.state.graphs.map { it.lines } shouldBe listOf(listOf("Time"), listOf("Arm/Angle"))
    }

    test("a change of the axis keeps a person's own graphs and formulas") {
        val viewer = viewerOf(recordingOf(text).withFormulas(listOf("Twice = 2 * Arm/Angle")))
        viewer.formulas.replaceAll(listOf("Twice = 2 * Arm/Angle"))
        val own = Board().withGraph(listOf("Twice"))
        viewer.board.replace(own)
        choosing(viewer) { viewer.axis.choose(true) }
        viewer.board.state shouldBe own
        viewer.current.recording?.signal("Twice")?.series?.size shouldBe 20
    }

    test("after the choice of an axis, logs are read with it, and the question is not repeated") {
        val log = Files.writeString(tempdir().toPath().resolve("a.bag"), text)
        val viewer = viewerOf(null)
        viewer.axis.choose(true)
        val read = OpenRecording.read(log)
        choosing(viewer) { viewer.show(read) }
        viewer.view.viewport.full shouldBe Span(10.0, 19.5)
        viewer.axis.offered.shouldBeNull()
        OpenRecording.read(log, choices = { RecordingChoices(overTime = true) }).span shouldBe Span(10.0, 19.5)
    }

    test("no axis is offered for a log with an x axis, or for plain CSV, which is drawn over its time") {
        viewerOf(recordingOf(text.replace("\"Time\",\"unit\":\"V\",\"attrs\":[]", "\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]"))).axis.offered.shouldBeNull()
        val log = Files.writeString(tempdir().toPath().resolve("a.csv"), "Time,Angle\n1,2\n2,3\n")
        viewerOf(OpenRecording.read(log)).axis.offered.shouldBeNull()
    }
})
