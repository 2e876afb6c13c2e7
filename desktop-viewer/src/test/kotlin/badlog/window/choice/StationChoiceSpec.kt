package badlog.window.choice

import badlog.core.analysis.Span
import badlog.signals.clock.ClockFit
import badlog.window.export.partOf
import badlog.window.findings.findingsOf
import badlog.window.graph.choosing
import badlog.window.graph.viewerOf
import badlog.window.graph.withFormulas
import badlog.window.log.OpenRecording
import badlog.window.putPair
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe

class StationChoiceSpec : FunSpec({
    test("the Driver Station's log of the match is shown over the same time, used by rules, and hidden again") {
        val log = putPair(tempdir().toPath())
        val viewer = viewerOf(OpenRecording.read(log))
        viewer.stations.change { StationOfLog(log, stationBeside(OpenRecording.read(log), null)) }
        choosing(viewer) { viewer.stations.choose(true) }
        val shown = checkNotNull(viewer.current.recording)
        shown.span shouldBe Span(-3.0, 13.98)
        viewer.view.viewport.full shouldBe shown.span
        findingsOf(shown.forRules, log, null).all.flatMap { it.evidence } shouldContain "Driver Station/Battery Voltage"
        // A saved part has only the topics of the robot's log.
        partOf(shown, Span(0.0, 1.0)).recording.topics.map { it.name } shouldBe listOf("Time", "Robot/Enabled", "Arm/Angle")
        choosing(viewer) { viewer.stations.choose(false) }
        checkNotNull(viewer.current.recording).run { station.shouldBeNull() }
        viewer.settings.state.stations shouldBe mapOf(log.toString() to false)
        viewer.stations.offered.shouldBeNull()
    }

    test("the choice for a log is kept when it is reopened, and formulas can use the Driver Station's topics") {
        val log = putPair(tempdir().toPath())
        val viewer = viewerOf(OpenRecording.read(log))
        viewer.stations.change { StationOfLog(log, stationBeside(OpenRecording.read(log), null)) }
        choosing(viewer) { viewer.stations.choose(true) }
        val again = OpenRecording.read(log)
        choosing(viewer) { viewer.show(again) }
        val shown = checkNotNull(viewer.current.recording)
        shown.station?.log?.name shouldBe "2026_03_07 10_04_05 Sat.dslog"
        shown.withFormulas(listOf("Twice = 2 * Driver Station/Trip Time")).signal("Twice")?.series?.y?.max() shouldBe 180.0
    }

    test("the shown error is at least the Driver Station's period, and alignment by clocks only is marked") {
        alignmentText(ClockFit(1.0, 4, 0.0)) shouldBe "± 0.02 s"
        alignmentText(ClockFit(1.0, 4, 0.031)) shouldBe "± 0.04 s"
        alignmentText(ClockFit(1.0, 0, 1.0)) shouldBe "± 1 s, aligned by the clocks only"
    }
})
