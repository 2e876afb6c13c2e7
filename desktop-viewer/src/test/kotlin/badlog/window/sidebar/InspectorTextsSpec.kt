package badlog.window.sidebar

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.shown.cursor.CursorValues
import badlog.window.bagOf
import badlog.window.compare.DrawnRecording
import badlog.window.graph.sample
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

    test("the cursor's values are the topics of the graphs, or of a search, and those that just changed come first") {
        val open = recordingOf(bagOf(listOf("Time|xaxis", "A", "B", "Mode"), listOf("0,1,5,off", "1,1,5,off", "2,1,9,off", "3,1,9,on")))
        val board = Board().withGraph(listOf("A", "B"))
        cursorSignals(open, board, "").map { it.name } shouldContainExactly listOf("A", "B")
        cursorSignals(open, board, "mo").map { it.name } shouldContainExactly listOf("Mode")
        cursorSignals(open, board, "is:state | has:finding", setOf("B")).map { it.name } shouldContainExactly listOf("B", "Mode")
        val shown = cursorSignals(open, board, "")
        val values = CursorValues(shown.map { it.line }, open.view.xAxis)
        cursorRows(shown, values, 2.0).map { it.name to it.text } shouldContainExactly listOf("B" to "9 V", "A" to "1 V")
        cursorRows(shown, values, 0.0).map { it.name } shouldContainExactly listOf("A", "B")
        cursorRows(shown, values, null).map { it.text } shouldContainExactly listOf("", "")
    }

    test("statistics cover the range in each recording where it lies, and can be copied to a spreadsheet") {
        val open = recordingOf(bagOf(listOf("Time|xaxis", "A", "Mode"), listOf("0,1,off", "1,3,o\tn", "2,5,o\tn", "3,9,o\tn")))
        val other = recordingOf(bagOf(listOf("Time|xaxis", "A"), listOf("10,1", "11,4", "12,6")), "other.bag")
        val statistics = rangeStatistics(
            listOf(DrawnRecording(open), DrawnRecording(other, -10.0)),
            listOf("A", "Mode", "Missing"),
            NamedSpan("Selection", Span(1.0, 2.0)),
        )
        fun cells(index: Int) = statistics.signals[index].cells.associate { it.name to it.text }
        statistics.signals.map { it.signal to it.recording } shouldContainExactly
            listOf("A" to "test.bag", "A" to "other.bag", "Mode" to "test.bag")
        cells(0)["mean"] shouldBe "3"
        cells(0)["last − first"] shouldBe "2"
        cells(0)["integral"] shouldBe "3"
        cells(1)["max"] shouldBe "6"
        cells(2) shouldBe mapOf("first" to "o\tn", "last" to "o\tn", "samples" to "2", "in o\tn" to "1 V, 1×")
        val lines = statistics.toTsv().lines()
        lines.map { it.count { char -> char == '\t' } }.dropLast(1).distinct().size shouldBe 1
        lines[1].split('\t').take(5) shouldContainExactly listOf("A", "V", "test.bag", "1", "2")
    }

    test("channels of the power distribution are ranked over the range") {
        val statistics = rangeStatistics(listOf(DrawnRecording(sample("qualification-42.bag"))), emptyList(), NamedSpan("Push", Span(92.0, 95.0)))
        statistics.channels.take(4).map { it.name }.toSet() shouldBe setOf("Current 0", "Current 1", "Current 14", "Current 15")
        statistics.channels.zipWithNext().all { (more, less) -> more.charge!! >= less.charge!! } shouldBe true
    }

    test("the statistics of a graph with two lines include their difference") {
        val open = recordingOf(bagOf(listOf("Time|xaxis", "Drive/Target", "Drive/Actual"), List(101) { "${it / 10.0},${it % 7},${it % 7 + 0.5}" }))
        val part = NamedSpan("Whole log", open.span)
        val statistics = rangeStatistics(listOf(DrawnRecording(open)), emptyList(), part, listOf(listOf("Drive/Target", "Drive/Actual")))
        val difference = statistics.signals.single()
        difference.signal shouldBe "Actual − Target"
        difference.cells.take(3).map { it.text } shouldContainExactly listOf("0.5 V", "0.5 V", "0.5 V")
    }

    test("statistics are shown with six digits, and copied with all of them") {
        val open = recordingOf(bagOf(listOf("Time|xaxis", "A"), listOf("0,11.599600000000002", "1,11.599600000000002")))
        val statistics = rangeStatistics(listOf(DrawnRecording(open)), listOf("A"), NamedSpan("Selection", Span(0.0, 1.0)))
        statistics.signals.single().cells.first { it.name == "max" }.text shouldBe "11.5996"
        val (head, cells) = statistics.toTsv().lines().map { it.split('\t') }
        cells[head.indexOf("max")] shouldBe "11.599600000000002"
    }
})
