package badlog.viewer.shown.statistics

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.bag.BagParser
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.signalTopicsOf
import badlog.viewer.panel.Measured
import badlog.viewer.panel.NamedSpan
import badlog.viewer.panel.Table
import badlog.viewer.panel.statisticsOf
import badlog.viewer.state.Action
import badlog.viewer.state.StatisticsState
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

class ChannelsSpec : FunSpec({
    fun channelsOf(vararg names: String, unit: String = "A", values: (second: Int) -> List<Double>): Channels {
        val topics = listOf("""{"name":"Time","unit":"s","attrs":["xaxis"]}""") + names.map { """{"name":"$it","unit":"$unit","attrs":[]}""" }
        val rows = (0..100).joinToString("\n") { (listOf("$it") + values(it)).joinToString(",") }
        val text = """{"topics":$topics,"values":[]}""" + "\nTime,${names.joinToString(",")}\n$rows\n"
        val view = LogView.of(BagParser().apply { accept(text.encodeToByteArray()) }.finish())
        return Channels.of(view, signalTopicsOf(view, RuleSet.BUILT_IN.signals))
    }

    val all = listOf(Span(0.0, 100.0))

    test("the panel of statistics ranks channels, and sorts them by the column that a person chooses") {
        val channels = channelsOf("PDP/Current 0", "PDP/Current 1", "PDP/Current 2") { listOf(36.0, if (it == 50) 90.0 else 0.0, 0.0) }
        val axis = LogView.of(BagParser().finish()).xAxis
        fun table(state: StatisticsState) = statisticsOf(Measured(emptyList(), emptyList(), channels), NamedSpan("Whole log", all.single()), axis, state, emptyMap()).last() as Table
        val ranked = table(StatisticsState())
        ranked.columns.map { it.title to it.isDescending } shouldContainExactly
            listOf("Channel" to null, "Charge" to true, "Peak" to null, "Share" to null)
        ranked.rows.map { row -> row.name to row.cells.drop(1).map { it.single().text } } shouldContainExactly
            listOf("Current 0" to listOf("1 Ah", "36 A", "97.6 %"), "Current 1" to listOf("0.025 Ah", "90 A", "2.4 %"))
        table((ranked.columns[2].sort as Action.Measure).statistics).rows.first().name shouldBe "Current 1"
    }

    test("only the parts of x count") {
        val channels = channelsOf("PDP/Current 0", "PDP/Current 1") { if (it < 50) listOf(10.0, 0.0) else listOf(0.0, 20.0) }
        channels.ranked(listOf(Span(60.0, 70.0)), ChannelOrder.CHARGE).map { it.name } shouldContainExactly listOf("Current 1")
        channels.ranked(listOf(Span(0.0, 10.0), Span(60.0, 70.0)), ChannelOrder.CHARGE).map { it.name } shouldContainExactly
            listOf("Current 1", "Current 0")
    }

    test("currents in other units are amperes, and without channels motors are shown") {
        channelsOf("PDP/Current 0", unit = "mA") { listOf(5000.0) }.ranked(all, ChannelOrder.PEAK).single().peakText shouldBe "5 A"
        channelsOf("Arm/Supply Current") { listOf(5.0) }.ranked(all, ChannelOrder.PEAK).single().topic shouldBe "Arm/Supply Current"
        channelsOf("Arm/Angle", unit = "deg") { listOf(5.0) }.ranked(all, ChannelOrder.PEAK).shouldBeEmpty()
    }
})
