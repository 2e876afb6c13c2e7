package badlog.expression

import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Vocabulary
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf

class NamesByWordsSpec : FunSpec({
    val names = listOf("/SystemStats/BatteryVoltage", "battery", "/Left/StatorCurrent", "/Right/StatorCurrent", "/Arm/Current_Angle")
    val vocabulary = Vocabulary(names.map { Signal(it, SignalKind.NUMBER) })

    val withSignal = Vocabulary(vocabulary.signals, hasTime = true, meanings = setOf("battery", "total current"))

    fun topicOf(text: String) = Expression.parse("$text > 1", vocabulary).shouldBeInstanceOf<Expression>().topics.single()

    test("words find a topic, however they are joined, and in any order") {
        for (text in listOf("battery voltage", "Battery Voltage", "voltage of the battery", "BATTERY_VOLTAGE")) {
            topicOf(text) shouldBe "/SystemStats/BatteryVoltage"
        }
        topicOf("angle current") shouldBe "/Arm/Current_Angle"
    }

    test("a name itself comes before words, and a single word is a name") {
        topicOf("battery") shouldBe "battery"
        Expression.parse("angle > 1", vocabulary).shouldBeInstanceOf<ExpressionError>()
    }

    test("words that match two topics are ambiguous") {
        Expression.parse("current stator > 1", vocabulary).shouldBeInstanceOf<ExpressionError>()
    }

    test("word operators end a name") {
        Expression.parse("battery voltage > 1 and battery < 13", vocabulary).shouldBeInstanceOf<Expression>().topics shouldBe
            setOf("/SystemStats/BatteryVoltage", "battery")
    }

    test("the message about unknown words names the most similar topic and signal") {
        fun messageFor(text: String) = Expression.parse(text, withSignal).shouldBeInstanceOf<ExpressionError>().run { this.text.substring(from, until) to message }
        for (text in listOf("battery voltge", "Voltge Battery", "BateryVoltage", "battery_voltag")) {
            messageFor("max($text) > 1").first shouldBe text
        }
        messageFor("max(battery voltge)").second shouldBe
            "“battery voltge” is not a topic or signal of this log. Did you mean “/SystemStats/BatteryVoltage” or `battery`?"
        messageFor("max(voltge battery)").second shouldBe
            "“voltge battery” is not a topic or signal of this log. Did you mean “/SystemStats/BatteryVoltage” or `battery`?"
        messageFor("batery > 1").second shouldBe "“batery” is not a topic or signal of this log. Did you mean `battery`?"
        messageFor("xyz > 1").second shouldBe "“xyz” is not a topic or signal of this log."
    }
})
