package badlog.core.analysis

import badlog.core.bag.BagParser
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private const val HEADER =
    """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"System/Enabled","unit":"ul","attrs":["hide"]},""" +
        """{"name":"System/Autonomous","unit":"ul","attrs":[]}],"values":[]}"""

private fun LogView.enabledBy(enabled: FlagTopic?, autonomous: FlagTopic? = null) = identified(title, ModeTopics(enabled, autonomous)).enabledSpans()

private val ENABLED = FlagTopic("System/Enabled", FlagReading.Truth)
private val AUTONOMOUS = FlagTopic("System/Autonomous", FlagReading.Truth)

private fun spans(vararg rows: String): List<EnabledSpan> {
    val parser = BagParser()
    val titles = "Time,System/Enabled,System/Autonomous"
    parser.accept((listOf(HEADER, titles) + rows).joinToString("\n", postfix = "\n").encodeToByteArray())
    return LogView.of(parser.finish()).enabledBy(ENABLED, AUTONOMOUS)
}

class EnabledSpanSpec : FunSpec({
    test("enabled spans are autonomous or teleop, and exclude disabled time") {
        spans("0,false,true", "1,true,true", "2,true,false", "3,true,false", "4,false,false", "5,true,false") shouldBe listOf(
            EnabledSpan(Span(1.0, 2.0), isAutonomous = true),
            EnabledSpan(Span(2.0, 4.0), isAutonomous = false),
            EnabledSpan(Span(5.0, 5.0), isAutonomous = false),
        )
    }

    test("test mode is neither autonomous nor teleop, and each span has the op mode at its start") {
        val parser = BagParser()
        val topics = listOf("Time" to "xaxis", "On" to "", "Alone" to "", "Test" to "", "Op" to "")
        val header = topics.joinToString(",", "{\"topics\":[", "],\"values\":[]}") { (name, attribute) ->
            """{"name":"$name","unit":"${if (name == "Time") "s" else "ul"}","attrs":[${if (attribute.isEmpty()) "" else "\"$attribute\""}]}"""
        }
        val rows = listOf("0,false,false,false,", "1,true,true,false,Two pieces", "2,true,false,false,Drive", "3,true,false,true,Drive", "4,false,false,false,")
        parser.accept((listOf(header, "Time,On,Alone,Test,Op") + rows).joinToString("\n", postfix = "\n").encodeToByteArray())
        fun flag(name: String) = FlagTopic(name, FlagReading.Truth)
        val view = LogView.of(parser.finish()).identified(null, ModeTopics(flag("On"), flag("Alone"), flag("Test"), "Op"))
        view.enabledSpans() shouldBe listOf(
            EnabledSpan(Span(1.0, 2.0), isAutonomous = true, opMode = "Two pieces"),
            EnabledSpan(Span(2.0, 3.0), isAutonomous = false, opMode = "Drive"),
            EnabledSpan(Span(3.0, 4.0), isAutonomous = false, isTest = true, opMode = "Drive"),
        )
    }

    test("numbers show when the robot was enabled, like truth values") {
        spans("0,0,0", "1,1.0000,0", "2,0,0") shouldBe listOf(EnabledSpan(Span(1.0, 2.0), isAutonomous = false))
    }

    test("a disabled flag, a bit of a word, and a state show when the robot was enabled") {
        fun spans(reading: FlagReading, vararg cells: String): List<Span> {
            val parser = BagParser()
            val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Mode","unit":"ul","attrs":[]}],"values":[]}"""
            val rows = cells.mapIndexed { i, cell -> "$i,$cell" }
            parser.accept((listOf(header, "Time,Mode") + rows).joinToString("\n", postfix = "\n").encodeToByteArray())
            return LogView.of(parser.finish()).enabledBy(FlagTopic("Mode", reading)).map { it.span }
        }
        spans(FlagReading.Opposite, "true", "false", "true", "") shouldBe listOf(Span(1.0, 2.0))
        spans(FlagReading.Bits(1, 1, 1), "1", "34", "35", "33") shouldBe listOf(Span(1.0, 3.0))
        spans(FlagReading.Bits(1, 2, 2), "1", "36", "37", "35") shouldBe listOf(Span(1.0, 3.0))
        spans(FlagReading.Text("auto"), "Disabled", "Autonomous", "Teleop", "Teleop") shouldBe listOf(Span(1.0, 2.0))
    }

    test("without a mode topic, or if x goes backwards, there are no enabled spans") {
        val parser = BagParser()
        parser.accept("Time,On\n0,true\n1,true\n".encodeToByteArray())
        LogView.of(parser.finish()).enabledBy(null) shouldBe emptyList()
        LogView.of(parser.finish()).enabledBy(ENABLED) shouldBe emptyList()
        spans("1,true,false", "0,true,false") shouldBe emptyList()
        spans() shouldBe emptyList()
    }
})
