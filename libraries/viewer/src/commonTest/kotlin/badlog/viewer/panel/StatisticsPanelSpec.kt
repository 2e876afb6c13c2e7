package badlog.viewer.panel

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.viewer.bagView
import badlog.viewer.choices.range.Viewport
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.statistics.Histogram
import badlog.viewer.shown.statistics.StateTime
import badlog.viewer.shown.statistics.Statistic
import badlog.viewer.state.Action
import badlog.viewer.state.Place
import badlog.viewer.state.StatisticsRange
import badlog.viewer.state.StatisticsState
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.types.shouldBeInstanceOf

class StatisticsPanelSpec : FunSpec({
    val view = bagView(listOf("Time|xaxis", "A", "Mode"), listOf("0,1,off", "1,3,on", "2,5,on", "3,11.599600000000002,on"))
    val all = NamedSpan("Whole log", Span(0.0, 3.0))
    val state = StatisticsState()

    fun LogView.line(name: String): GraphSeries = seriesOf(recording.topics.first { it.name == name })

    fun LogView.measured(vararg names: String) = names.mapIndexed { i, name -> MeasuredLine(line(name), name, i) }

    fun statistics(lines: List<MeasuredLine>, part: NamedSpan, unfolded: Map<String, Boolean> = emptyMap()) = statisticsOf(Measured(listOf(lines), listOf(lines), channels = null), part, view.xAxis, state, unfolded)

    fun List<Part>.tables() = filterIsInstance<Table>()

    fun Table.cells(row: Int) = columns.drop(1).map { it.title }.zip(rows[row].cells.drop(1).map { it.single() }).toMap()

    test("the range is the selection, otherwise that between both cursors, otherwise the visible one; or another that a person chose") {
        val place = Place(Viewport.of(0.0..100.0).moved(10.0, 20.0))
        val selected = place.copy(selection = Span(12.0, 13.0), cursors = Cursors(15.0, 12.0))
        val cursors = selected.copy(selection = null)
        val twice = listOf(10.0 to 20.0, 20.0 to 30.0, 40.0 to 50.0).map { (from, to) -> EnabledSpan(Span(from, to), isAutonomous = false) }
        selected.spanOf(StatisticsRange.SHOWN, twice) shouldBe NamedSpan("Selection", Span(12.0, 13.0))
        cursors.measured shouldBe NamedSpan(Cursors.BETWEEN, Span(12.0, 15.0))
        place.measured shouldBe NamedSpan("Visible range", Span(10.0, 20.0))
        place.spanOf(StatisticsRange.ALL, twice) shouldBe NamedSpan("Whole log", Span(0.0, 100.0))
        val enabled = place.spanOf(StatisticsRange.ENABLED, twice)
        enabled shouldBe NamedSpan("Time enabled", Span(10.0, 50.0), listOf(Span(10.0, 30.0), Span(40.0, 50.0)))
        enabled.text(view.xAxis) shouldBe "Time enabled: 30.000 V (10.000 – 50.000 V)"
        place.spanOf(StatisticsRange.ENABLED, emptyList()) shouldBe place.measured
        fun labels(at: Place, spans: List<EnabledSpan>) = rangeChoice(at, spans, state).options.map { it.label }
        labels(selected, twice) shouldContainExactly listOf("Selected", "Enabled", "All")
        labels(cursors, emptyList()) shouldContainExactly listOf("A–B", "All")
        val options = rangeChoice(place, twice, state.copy(range = StatisticsRange.ALL)).options
        options.map { it.label to it.isOn } shouldContainExactly listOf("Visible" to false, "Enabled" to false, "All" to true)
        options[1].action.shouldBeInstanceOf<Action.Measure>().statistics.range shouldBe StatisticsRange.ENABLED
    }

    test("each line has all statistics over the range where it lies in its log, with six digits, and exactly for copies") {
        val other = bagView(listOf("Time|xaxis", "A"), listOf("10,1", "11,4", "12,6"))
        val lines = view.measured("A") + MeasuredLine(other.line("A"), "A", 1, "other", -10.0)
        val parts = statistics(lines, NamedSpan("Selection", Span(1.0, 2.0)))
        (parts.first() as Paragraph).text shouldBe "Selection: 1.0000 V (1.0000 – 2.0000 V). ${Statistic.BY_TIME}"
        val table = parts.tables().first()
        table.rows.map { row -> row.cells[0].map { it.text to it.color } } shouldContainExactly listOf(listOf("A" to 0), listOf("A" to null, "other" to 1))
        table.cells(0).run { listOf("mean", "last − first", "integral").map { getValue(it).text } } shouldContainExactly listOf("3", "2", "3")
        table.cells(0).getValue("mean").unit shouldBe "V"
        table.cells(1).getValue("max").text shouldBe "6"
        val most = statistics(view.measured("A"), all).tables().single().cells(0).getValue("max")
        most.text shouldBe "11.5996"
        most.hint shouldBe "11.599600000000002"
    }

    test("a line with states has the time in each of them, in rows of its own, and no statistics by time") {
        val parts = statistics(view.measured("Mode"), NamedSpan("Visible range", Span(0.0, 3.0)))
        (parts.first() as Paragraph).text shouldNotContain Statistic.BY_TIME
        val table = parts.tables().single()
        table.columns.map { it.title } shouldContainExactly StateTime.TITLES
        table.rows.map { row -> row.cells.map { cells -> cells.joinToString { it.text } } } shouldContainExactly listOf(listOf("Mode", "on", "2 V", "66.7 %", "1"), listOf("", "off", "1 V", "33.3 %", "1"))
    }

    test("lines of a graph have their difference from the first") {
        val two = bagView(listOf("Time|xaxis", "Target", "Actual"), List(101) { "${it / 10.0},${it % 7},${it % 7 + 0.5}" })
        val (lines, difference) = statistics(two.measured("Target", "Actual"), NamedSpan("Whole log", Span(0.0, 10.0))).tables()
        lines.rows.map { it.name } shouldContainExactly listOf("Target", "Actual")
        difference.rows.single().name shouldBe "Actual − Target"
        difference.rows.single().cells.flatten().drop(1).take(3).map { it.text } shouldContainExactly listOf("0.5 V", "0.5 V", "0.5 V")
    }

    test("the histogram of a line is opened from its row, and closed again; a sentence replaces a missing one") {
        val open = statistics(view.measured("A"), all).tables().single().rows.single().cells[0][0].tools.single()
        open.isOn shouldBe false
        val key = open.action.shouldBeInstanceOf<Action.Unfold>().run {
            isOpen shouldBe true
            fold
        }
        val opened = statistics(view.measured("A"), all, mapOf(key to true))
        opened.filterIsInstance<Picture>().single().name shouldBe "Histogram of A"
        opened.tables().single().rows.single().cells[0][0].tools.single().isOn shouldBe true
        val flat = bagView(listOf("Time|xaxis", "A"), listOf("0,7", "3,7"))
        statistics(flat.measured("A"), all, mapOf(key to true)).filterIsInstance<Paragraph>().last().text shouldBe Histogram.NONE
        statistics(view.measured("Mode"), all).tables().single().rows.first().cells[0][0].tools.shouldBeEmpty()
    }

    test("two lines whose names end alike have histograms of their own") {
        val sides = bagView(listOf("Time|xaxis", "Left/Speed", "Right/Speed"), listOf("0,1,2", "3,5,7"))
        val keys = statistics(sides.measured("Left/Speed", "Right/Speed"), all).tables().first().rows.map { row ->
            row.cells[0][0].tools.single().action.shouldBeInstanceOf<Action.Unfold>().fold
        }
        keys.distinct().size shouldBe 2
        statistics(sides.measured("Left/Speed", "Right/Speed"), all, mapOf(keys[1] to true)).filterIsInstance<Picture>().size shouldBe 1
    }

    test("what is visible is measured where the chosen range is unknown, and its button says so") {
        val place = Place(Viewport.of(0.0..100.0))
        rangeChoice(place, emptyList(), state.copy(range = StatisticsRange.ENABLED)).options.map { it.isOn } shouldContainExactly listOf(true, false)
    }

    test("copied statistics have the same number of cells in each line") {
        val tables = statistics(view.measured("A", "Mode"), all).tables()
        val lines = tsvOf(tables, all).lines()
        lines.dropLast(1).map { line -> line.count { it == '\t' } }.distinct().size shouldBe 1
        val (head, first) = lines.map { it.split('\t') }
        first.take(5) shouldContainExactly listOf("A", "V", "", "0", "3")
        first[head.indexOf("max")] shouldBe "11.599600000000002"
        lines[2] shouldContain "on\t2 V"
    }
})
