package badlog.viewer.choices.board

import badlog.viewer.draw.path.xyPlotOf
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe

class XySearchSpec : FunSpec({
    val names = listOf("Battery/Voltage", "Battery/Current", "Arm/Current", "Overload", "Turnover/Rate")

    fun titles(text: String) = xyGraphs(names, text).map { it.title }

    test("one search over another offers each pair of topics, the second as x") {
        titles("volt over CURRENT") shouldBe listOf("Battery/Voltage over Battery/Current", "Battery/Voltage over Arm/Current")
        titles("battery volt  Over  arm") shouldBe listOf("Battery/Voltage over Arm/Current")
        val graph = xyGraphs(names, "voltage over arm").single()
        graph.lines shouldBe listOf("Arm/Current", "Battery/Voltage")
        graph.isXy shouldBe true
    }

    test("a topic is not offered over itself") {
        titles("battery over battery") shouldBe listOf("Battery/Voltage over Battery/Current", "Battery/Current over Battery/Voltage")
    }

    test("without two searches around the word “over” nothing is offered") {
        for (text in listOf("", "over", "volt", "volt over", "volt over ", " over volt", "volt over - ", "overload", "turnover", "a over b over c")) {
            titles(text) shouldBe emptyList()
        }
        titles("overload over turnover") shouldBe listOf("Overload over Turnover/Rate")
    }

    test("only a few of thousands of pairs are offered") {
        val many = List(2_000) { "Motor $it/Current" }
        xyGraphs(many, "motor over motor") shouldHaveSize 20
    }

    test("the offered graph draws y over x") {
        val view = timedView(timedTopic("Volts", 0.0 to 12.0, 1.0 to 11.0), timedTopic("Amps", 0.0 to 5.0, 1.0 to 50.0))
        val graph = xyGraphs(view.recording.topics.map { it.name }, "volts over amps").single()
        val plot = xyPlotOf(graph.lines, emptyList()) { name -> view.recording.topics.find { it.name == name }?.let(view::seriesOf) }.shouldNotBeNull()
        plot.xTitle shouldBe "Amps (V)"
        plot.yTitle shouldBe "Volts (V)"
    }
})
