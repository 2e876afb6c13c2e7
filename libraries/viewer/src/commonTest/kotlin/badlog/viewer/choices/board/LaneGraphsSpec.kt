package badlog.viewer.choices.board

import badlog.viewer.bagView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class LaneGraphsSpec : FunSpec({
    val topics = listOf("Time|xaxis|hide", "A/Mode", "A/On", "A/Angle", "A/Off")
    val graphs = bagView(topics, listOf("0,auto,true,1,false", "1,teleop,false,2,true")).folders.single().graphs

    test("consecutive states share a graph with a lane each, and everything else has its own graph") {
        framesOf(graphs).map(::laneGraphOf).map { it.name to it.series.map { line -> line.topic.name } } shouldBe listOf(
            "A/States" to listOf("A/Mode", "A/On"),
            "A/Angle" to listOf("A/Angle"),
            "A/Off" to listOf("A/Off"),
        )
    }

    test("a graph can have a frame of its own") {
        framesOf(graphs) { it.name == "A/On" }.map { it.size } shouldBe listOf(1, 1, 1, 1)
        framesOf(graphs) { it.name == "A/Mode" }.map { it.size } shouldBe listOf(1, 1, 1, 1)
    }

    test("no frame has more lanes than fit on a screen") {
        val many = bagView(listOf("Time|xaxis|hide") + List(40) { "S$it" }, listOf("0" + ",true".repeat(40), "1" + ",false".repeat(40)))
        framesOf(many.folders.single().graphs).map { it.size } shouldBe listOf(16, 16, 8)
    }
})
