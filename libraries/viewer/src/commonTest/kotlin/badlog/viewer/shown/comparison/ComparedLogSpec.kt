package badlog.viewer.shown.comparison

import badlog.core.analysis.LogView
import badlog.core.analysis.statistics
import badlog.viewer.bagView
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.choices.board.lineNames
import badlog.viewer.choices.range.holdsUntil
import badlog.viewer.choices.range.stateRuns
import badlog.viewer.shown.cursor.indexAt
import badlog.viewer.shown.cursor.textOf
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

class ComparedLogSpec : FunSpec({
    val topics = listOf("Time|xaxis|hide", "A/Volts|join:A/Both", "A/State", "A/Amps|join:A/Both")
    val open = bagView(topics, listOf("0,12,IDLE,1", "1,11,IDLE,2", "2,10,SHOOT,3"))
    val other = bagView(topics, listOf("5,8,IDLE,1", "6,7,IDLE,2"))

    fun compared(view: LogView, offset: Double = 0.0, name: String = "Q2") = ComparedLog(name, BoardLines(view), offset)

    test("the lines of another log are beside the open log's lines, moved, with their log's name") {
        val graph = open.folders.flatMap { it.graphs }.first { it.name == "A/Both" }
        val both = comparedGraph(graph, graph.lineNames, listOf(compared(other, offset = -5.0)))
        both.lines shouldContainExactly listOf("A/Volts", "A/Volts", "A/Amps", "A/Amps")
        both.graph.series.map { it.topic.name } shouldContainExactly listOf("A/Volts", "A/Volts (Q2)", "A/Amps", "A/Amps (Q2)")
        both.graph.series[1].data.x.toList() shouldContainExactly listOf(0.0, 1.0)
        both.graph.series[1].data.y.toList() shouldContainExactly listOf(8.0, 7.0)
    }

    test("the last values of a log of changes hold until its own end, however long the open one is") {
        val longer = timedView(timedTopic("A", 0.0 to 1.0), timedTopic("End", 20.0 to 0.0))
        val shorter = timedView(timedTopic("A", 100.0 to 5.0, 102.0 to 7.0), timedTopic("End", 104.0 to 0.0))
        val graph = longer.folders.flatMap { it.graphs }.first { it.name == "A" }
        val (own, other) = comparedGraph(graph, graph.lineNames, listOf(compared(shorter, offset = -100.0))).graph.series
        own.holdsUntil shouldBe 20.0
        other.holdsUntil shouldBe 4.0
        other.statistics().mean shouldBe 6.0
        other.statistics(0.0, 20.0).integral shouldBe 24.0
        other.textOf(other.indexAt(4.0)) shouldBe "7"
        other.textOf(other.indexAt(4.5)) shouldBe "–"
        other.textOf(other.indexAt(-0.5)) shouldBe "–"
        other.stateRuns().to.last() shouldBe 4.0
    }

    test("a line that the other log lacks, or has as another kind, is drawn alone") {
        val graph = open.folders.flatMap { it.graphs }.first { it.showsStates }
        val numbers = bagView(listOf("Time|xaxis", "A/State"), listOf("0,1", "1,2"))
        val others = bagView(listOf("Time|xaxis", "B"), listOf("0,1", "1,2"))
        for (view in listOf(numbers, others)) comparedGraph(graph, graph.lineNames, listOf(compared(view))).graph.series.size shouldBe 1
        val all = comparedGraph(graph, graph.lineNames, listOf(compared(other), compared(open, name = "Q3")))
        all.graph.series.map { it.topic.name } shouldContainExactly listOf("A/State", "A/State (Q2)", "A/State (Q3)")
    }

    test("the first line of each log has the same color in all graphs, even if another log lacks the line") {
        val graph = open.folders.flatMap { it.graphs }.first { it.name == "A/Both" }
        val poor = bagView(listOf("Time|xaxis|hide", "A/Amps"), listOf("0,1", "1,2"))
        val all = comparedGraph(graph, graph.lineNames, listOf(compared(poor), compared(other, name = "Q3")))
        all.graph.series.map { it.topic.name } shouldContainExactly listOf("A/Volts", "A/Volts (Q3)", "A/Amps", "A/Amps (Q2)", "A/Amps (Q3)")
        all.colors shouldContainExactly listOf(0, 2, 3, 4, 5)
        comparedGraph(graph, graph.lineNames, emptyList()).colors shouldContainExactly listOf(0, 1)
    }
})
