package badlog.signals.derived

import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.signals.vocabulary.SignalVocabulary
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class PartTopicSpec : FunSpec({
    fun part(name: String, unit: String = "", kind: SignalKind = SignalKind.NUMBER) = partTopicsOf(listOf(Signal(name, kind, unit)), SignalVocabulary.NONE).single()

    test("a switch is recognized in truth values and in numbers; a count of its presses and a limit are not switches") {
        for (kind in listOf(SignalKind.CONDITION, SignalKind.NUMBER)) {
            for (name in listOf("Elevator/Bottom Switch", "Elevator/Bottom Limit Switch", "Elevator/Lower Limit Switch Pressed")) {
                part(name, kind = kind).run {
                    quantity shouldBe Quantity.SWITCH
                    part shouldBe listOf("elevator")
                }
            }
        }
        part("Elevator/Bottom Limit", kind = SignalKind.CONDITION).quantity shouldBe Quantity.SWITCH
        part("Elevator/Switch Count").quantity shouldBe Quantity.NONE
        part("Elevator/Current Limit").quantity shouldBe Quantity.NONE
        part("Elevator/Switch Voltage", "V").quantity shouldBe Quantity.VOLTAGE
    }
})
