package badlog.window.findings

import badlog.window.app.Viewer
import badlog.window.change
import badlog.window.graph.sample
import badlog.window.graph.viewerOf
import badlog.window.kept
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe

class FindingEvidenceSpec : FunSpec({
    fun investigating(): Viewer = viewerOf(sample("qualification-42.bag")).apply {
        findings.change { withList(findingsIn(checkNotNull(current.recording))) }
    }

    test("one click on a brownout shows voltage, current and outputs around the moment") {
        val viewer = investigating()
        val incident = checkNotNull(viewer.findings.state.list).incidents.first()
        viewer.findings.goTo(incident.sentences.first { it.finding.rule == "Browned out" }.finding)
        val evidence = viewer.board.state.graphs.filter { it !in viewer.board.kept.graphs }
        evidence.flatMap { it.lines } shouldContainAll listOf("System/Battery Voltage", "PDP/Total Current", "Drivetrain/Left Output")
        (93.7 in viewer.view.viewport.visible) shouldBe true
        viewer.view.viewport.visible.width shouldBeLessThan 60.0
    }

    test("the graphs of a finding replace the graphs of the previous one, and no layout keeps them") {
        val viewer = investigating()
        val arranged = viewer.board.state
        val list = checkNotNull(viewer.findings.state.list)
        viewer.findings.goTo(list.all.first { it.rule == "Browned out" })
        val first = viewer.board.state
        viewer.findings.goTo(list.all.first { it.evidence != list.all.first { one -> one.rule == "Browned out" }.evidence && it.time.isFinite() })
        viewer.board.kept shouldBe arranged
        viewer.layouts.layout.graphs shouldBe null
        (viewer.board.state.graphs.size - arranged.graphs.size <= 4) shouldBe true
        (first == viewer.board.state) shouldBe false
    }

    test("a finding's graph that a person has changed stays") {
        val viewer = investigating()
        viewer.findings.goTo(checkNotNull(viewer.findings.state.list).all.first { it.rule == "Browned out" })
        val top = viewer.board.state.graphs.first()
        viewer.board.change { withLine(top.id, "System/Loop Time") }
        viewer.board.kept.graphs.map { it.id }.contains(top.id) shouldBe true
    }
})
