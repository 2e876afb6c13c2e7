package badlog.window.sidebar

import badlog.viewer.choices.board.Board
import badlog.window.bagOf
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

class InspectorTextsSpec : FunSpec({
    test("an event's time counts from the moment at which the robot was enabled") {
        val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Enabled","unit":"ul","attrs":[]}],"values":[]}"""
        val times = recordingOf("$header\nTime,Enabled\n0,0\n2.5,1\n200,1\n").times
        times.sinceEnabled(94.5) shouldBe "1:32.0"
        times.sinceEnabled(2.5) shouldBe "0:00.0"
        times.sinceEnabled(0.0) shouldBe "-0:02.5"
        times.sinceEnabled(Double.NaN) shouldBe null
        times.logged(94.5) shouldBe "94.50"
        recordingOf(bagOf(listOf("Time|xaxis", "A"), listOf("0,1"))).times.sinceEnabled(0.0) shouldBe null
    }

    test("the cursor's values are the topics of the graphs, or of a search") {
        val open = recordingOf(bagOf(listOf("Time|xaxis", "A", "B", "Mode"), listOf("0,1,5,off", "1,1,5,off", "2,1,9,off", "3,1,9,on")))
        val board = Board().withGraph(listOf("A", "B"))
        cursorSignals(open, board, "").map { it.name } shouldContainExactly listOf("A", "B")
        cursorSignals(open, board, "mo").map { it.name } shouldContainExactly listOf("Mode")
        cursorSignals(open, board, "is:state | has:finding", setOf("B")).map { it.name } shouldContainExactly listOf("B", "Mode")
    }
})
