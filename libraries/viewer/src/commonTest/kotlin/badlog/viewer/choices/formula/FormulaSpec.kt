package badlog.viewer.choices.formula

import badlog.expression.ExpressionError
import badlog.expression.LogViewSignals
import badlog.expression.VirtualTopic
import badlog.expression.withVirtualTopics
import badlog.viewer.bagView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class FormulaSpec : FunSpec({
    val power = "Power [W] = Battery Voltage * Total Current"
    val view = bagView(listOf("Time|xaxis", "System/Battery Voltage", "PDP/Total Current"), listOf("0,12,1", "1,11,2", "2,10,3"))
    val vocabulary = LogViewSignals(view).vocabulary

    test("an invalid formula does not affect the others, and only one of equal ones counts") {
        val definitions = listOf("A = Arm/Angle + 1", power, "Nothing", power, "B = Power / 2")
        val formulas = formulasOf(definitions, view.withVirtualTopics(definitions))
        formulas.map { it.definition } shouldContainExactly definitions
        formulas.map { it.topic?.name } shouldContainExactly listOf(null, "Power", null, null, "B")
        formulas.map { it.error == null } shouldContainExactly listOf(false, true, false, false, true)
        formulas.map { it.name } shouldContainExactly listOf("A", "Power", null, "Power", "B")
    }

    test("the name is known even if the expression is invalid") {
        nameIn(power) shouldBe "Power"
        nameIn("\"Odd = [name]\" [V] = nonsense == 3") shouldBe "Odd = [name]"
        nameIn("no definition") shouldBe null
        nameIn("= 3") shouldBe null
    }

    test("added formulas replace the ones with the same name and keep the others") {
        joined(listOf("A = 1", "B = 2"), listOf("B = 3", "C = 4")) shouldContainExactly listOf("A = 1", "B = 3", "C = 4")
        joined(listOf("A = 1"), emptyList()) shouldContainExactly listOf("A = 1")
    }

    test("a mistake at the end is a hint while a person types, and does not accuse the first word of a name") {
        fun remark(text: String) = (VirtualTopic.parse(text, vocabulary) as ExpressionError).whileTyping()
        remark("P = Battery Voltage * Total").run { text to isError } shouldBe ("Type on for a name, or “(” for the function Total." to false)
        remark("P = Battery Voltage * Tot").isError shouldBe false
        remark("P = Battery Voltage * ").isError shouldBe false
        remark("P = total * 2").run { text to isError } shouldBe ("total is a function; put its operands in parentheses after it." to true)
        remark("P = Batery + 2").isError shouldBe true
    }

    test("names are suggested for a typed part") {
        fun names(text: String) = Suggestions.of(text, text.length, vocabulary).names
        names("Volt") shouldBe emptyList()
        names("P = volt") shouldBe listOf("System/Battery Voltage")
        names("P = bat vol") shouldBe listOf("System/Battery Voltage")
        names("P = System/Battery Voltage * cur") shouldBe listOf("PDP/Total Current")
        names("P = System/Battery Voltage - cur") shouldBe listOf("PDP/Total Current")
        names("P = system/battery voltage") shouldBe emptyList()
        names("P = 2 when volt") shouldBe listOf("System/Battery Voltage")
        names("P = -volt") shouldBe emptyList()
        names("P = \"Tot") shouldBe listOf("PDP/Total Current")
        val found = Suggestions.of("P = 2 * (tot) ", 12, vocabulary)
        (found.from to found.until) shouldBe (9 to 12)
    }

    test("for any typed text, a suggestion replaces a part before the cursor") {
        checkAll(Arb.string(0..30), Arb.int(0..34)) { typed, place ->
            val text = "P = $typed"
            val cursor = place.coerceAtMost(text.length)
            val found = Suggestions.of(text, cursor, vocabulary)
            (found.from <= found.until && found.until == cursor) shouldBe true
        }
    }

    test("a name is in quotes if the language would not read it as one") {
        nameInExpression("System/Battery Voltage", vocabulary) shouldBe "System/Battery Voltage"
        val odd = LogViewSignals(bagView(listOf("Time|xaxis", "-odd", "a|b"), listOf("0,1,2"))).vocabulary
        nameInExpression("-odd", odd) shouldBe "\"-odd\""
    }
})
