package badlog.viewer.choices.formula

import badlog.expression.withVirtualTopics
import badlog.viewer.bagView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class FormulaUsersSpec : FunSpec({
    val definitions = listOf("Sum = A + 1", "Twice = Sum * 2", "Other = A * 3", "Again = Twice + Other", "Bad = Sum +")
    val view = bagView(listOf("Time|xaxis", "A"), listOf("0,1", "1,2"))
    val formulas = formulasOf(definitions, view.withVirtualTopics(definitions))

    test("the users of a formula name its topic, directly or through others, in their order") {
        formulas.usersOf("Sum = A + 1") shouldBe listOf("Twice = Sum * 2", "Again = Twice + Other")
        formulas.usersOf("Again = Twice + Other") shouldBe emptyList()
        formulas.usersOf("not one of them = 1") shouldBe emptyList()
    }

    test("a formula that others need is not removed, and the sentence names the others") {
        formulas.reasonToKeep("Twice = Sum * 2") shouldBe "“Again = Twice + Other” needs it; remove that first."
        formulas.reasonToKeep("Sum = A + 1") shouldBe "“Twice = Sum * 2”, “Again = Twice + Other” need it; remove that first."
        formulas.reasonToKeep("Again = Twice + Other") shouldBe null
    }

    test("a formula that others need keeps its name, but its expression may change") {
        formulas.reasonToKeepName("Twice = Sum * 2", "Double = Sum * 2") shouldBe "“Again = Twice + Other” needs this name; change that first."
        formulas.reasonToKeepName("Twice = Sum * 2", "Twice [m] = Sum * 2.0") shouldBe null
        formulas.reasonToKeepName("Again = Twice + Other", "New = Twice + Other") shouldBe null
    }
})
