package badlog.expression

import badlog.core.analysis.FlagReading
import badlog.core.analysis.FlagTopic
import badlog.core.analysis.LogView
import badlog.core.analysis.ModeTopics
import badlog.core.analysis.Span
import badlog.core.bag.BagParser
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Vocabulary
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import kotlin.random.Random

private fun virtual(text: String, vocabulary: Vocabulary) = when (val result = VirtualTopic.parse(text, vocabulary)) {
    is VirtualTopic -> result
    is ExpressionError -> throw AssertionError(result.pointed())
}

class VirtualTopicSpec : FunSpec({
    val vocabulary = names("Voltage", "PDP/Current")

    test("a definition has a name, an optional unit and an expression") {
        virtual("Power [W] = Voltage * Current", vocabulary).run {
            name shouldBe "Power"
            unit shouldBe "W"
            expression.topics shouldBe listOf("Voltage", "PDP/Current")
            toString() shouldBe "Power [W] = \"Voltage\" * \"PDP/Current\""
            signal shouldBe Signal("Power", SignalKind.NUMBER, "W")
        }
        virtual("Robot/Is Low=Voltage<7", vocabulary).run {
            name shouldBe "Robot/Is Low"
            unit shouldBe ""
            signal.kind shouldBe SignalKind.CONDITION
        }
        virtual("\"a=b [c]\" [m/s] = Voltage", vocabulary).run {
            name shouldBe "a=b [c]"
            unit shouldBe "m/s"
            virtual(toString(), vocabulary).toString() shouldBe toString()
        }
    }

    val errors = listOf(
        Triple(
            "Voltage * Current",
            "Voltage * Current",
            "A formula needs a name and =, as in Power [W] = Voltage * Current.",
        ),
        Triple(" [W] = Voltage", " [W] ", "The formula has no name before =."),
        Triple("Voltage = Voltage", "Voltage ", "“Voltage” already exists; use another name."),
        Triple("Current = 3", "Current ", "“Current” already means “PDP/Current”; use another name."),
        Triple("current = 3", "current ", "“current” already means “PDP/Current”; use another name."),
        Triple("true = 3", "true ", "“true” is a word of the language; use another name."),
        Triple("enabled [V] = 1", "enabled [V] ", "“enabled” is a word of the language; use another name."),
        Triple("\"a\" b = Voltage", "\"a\" b ", "Only a unit in brackets may be between a quoted name and =."),
        Triple("Power = Voltage * Curent", "Curent", "“Curent” is not a topic of this log. Did you mean “PDP/Current”?"),
    )
    for ((text, place, message) in errors) {
        test("“$text” is an error at “$place”") {
            val error = VirtualTopic.parse(text, vocabulary) as ExpressionError
            error.message shouldBe message
            text.substring(error.from, error.until) shouldBe place
            error.text shouldBe text
        }
    }

    test("any text is a virtual topic, or an error within the text") {
        val pieces = listOf("Voltage", "Power", "[", "]", "W", "=", "==", "\"", " ", "\n", "<", "(", "1")
        repeat(5 * PropertyTesting.defaultIterationCount) { seed ->
            val random = Random(seed)
            val text = List(random.nextInt(9)) { pieces[random.nextInt(pieces.size)] }.joinToString("")
            when (val result = VirtualTopic.parse(text, vocabulary)) {
                is VirtualTopic -> virtual(result.toString(), vocabulary).toString() shouldBe result.toString()

                is ExpressionError -> {
                    (result.from in 0..text.length && result.until in result.from..text.length) shouldBe true
                    result.pointed()
                }
            }
        }
    }

    val view = LogView.of(BagParser().apply { accept(VARIED_BAG.encodeToByteArray()) }.finish())
    val signals = LogViewSignals(view.identified(null, ModeTopics(FlagTopic("Enabled", FlagReading.Truth), null)))

    test("a bag's topics can be named, each with its kind") {
        signals.vocabulary.signals.map { it.name to it.kind } shouldBe listOf(
            "Time" to SignalKind.NUMBER,
            "Arm/Angle" to SignalKind.NUMBER,
            "Log" to SignalKind.EVENT,
            "Enabled" to SignalKind.CONDITION,
        )
        signals.range shouldBe Span(0.0, 0.1)
        signals.timeUnit shouldBe "s"
        fun answer(text: String) = parsed(text, signals.vocabulary).answer(signals).toString()
        answer("max(Angle)") shouldBe "max(Angle) = 99 deg at 0.1 s"
        answer("Log contains 'ready'") shouldBe "yes, at 0.02 s, and once more"
        answer("max(Angle when enabled) > 50") shouldBe "yes, max(Angle when enabled) = 99 deg at 0.1 s"
        answer("total(enabled)") shouldBe "total(enabled) = 0.06 s at 0.04 s"
        answer("Time > 50 ms and missing(Angle)") shouldBe "yes, Time = 0.08 s at 0.08 s, from 0.08 s to 0.1 s"
    }

    test("virtual topics can use other virtual topics") {
        val twice = virtual("Arm/Twice [deg] = 2 * Angle", signals.vocabulary)
        val both = signals.with(twice)
        val all = both.with(virtual("Low = Twice < 0", both.vocabulary))
        parsed("max(Twice)", all.vocabulary).answer(all).toString() shouldBe "max(Twice) = 198 deg at 0.1 s"
        parsed("Low and Log contains 'ready'", all.vocabulary).answer(all).toString() shouldBe "yes, at 0.02 s"
    }
})

private const val VARIED_BAG =
    """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis","hide"]},{"name":"Arm/Angle","unit":"deg","attrs":[]},""" +
        """{"name":"Log","unit":"ul","attrs":["log"]},{"name":"Enabled","unit":"ul","attrs":[]}],"values":[]}""" +
        "\nTime,Arm/Angle,Log,Enabled\n0.0000,12.346,,false\n0.020000,-1.2346e+05,\"armed, ready\",false\n" +
        "0.040000,,\"said \"\"go\"\"\ntwice\",true\n0.060000,1.0000e-05,,true\n0.080000,NaN,Ω ready,true\n0.10000,99.000,,true\n"
