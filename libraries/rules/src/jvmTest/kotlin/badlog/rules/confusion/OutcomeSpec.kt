package badlog.rules.confusion

import badlog.samples.generated.fault.FAULTS
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith

class OutcomeSpec : FunSpec({
    val fault = FAULTS.first { it.id == "unplugged-encoder" }
    val evidence = listOf("/Arm/Position")
    fun claim(text: String, isIncident: Boolean = false, topic: String = "/Arm/Position") = Claim(text, listOf(topic), isIncident)
    val right = claim(fault.cause)
    val other = claim("Something else.")

    test("a list without claims is silence") { outcomeOf(fault, evidence, emptyList()) shouldBe Outcome.SILENT }

    test("the right cause counts anywhere in the list, unless the list begins with another cause") {
        outcomeOf(fault, evidence, listOf(right)) shouldBe Outcome.RIGHT
        outcomeOf(fault, evidence, listOf(other, right)) shouldBe Outcome.RIGHT
        outcomeOf(fault, evidence, listOf(claim(other.text, isIncident = true), right)) shouldBe Outcome.WRONG
    }

    test("the right words about another part of the robot are wrong") {
        outcomeOf(fault, evidence, listOf(claim(fault.cause, topic = "/Elevator/Position"))) shouldBe Outcome.WRONG
    }

    test("a share has the interval to expect from other faults") {
        shareText(listOf(listOf(1, 1), listOf(1))) { it == 1 } shouldBe "100.0 % (100.0 to 100.0)"
        shareText(listOf(listOf(1), listOf(0))) { it == 1 } shouldStartWith "50.0 % (0.0 to 100.0)"
    }
})
