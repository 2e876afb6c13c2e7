package badlog.signals.match

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class SameMatchSpec : FunSpec({
    fun same(one: String, other: String): Boolean? {
        fun match(text: String) = text.split(' ').let { (type, number) -> MatchOfLog(type = type.takeIf { it != "?" }, number = number.takeIf { it != "?" }) }
        return match(one).isSameAs(match(other)).also { match(other).isSameAs(match(one)) shouldBe it }
    }

    test("contradictory numbers or types are two matches; missing ones decide nothing") {
        same("Qualification 17", "Qualification 17") shouldBe true
        same("Qualification 17", "? 17") shouldBe true
        same("Qualification 17", "Qualification 11") shouldBe false
        same("Qualification 17", "Practice 17") shouldBe false
        same("Qualification 17", "Practice ?") shouldBe false
        same("Qualification 17", "? ?") shouldBe null
        same("Qualification 17", "Elimination 17") shouldBe false
    }

    test("the same number at another event is open; one log may have the name of the event, and the other its code") {
        fun at(event: String?, number: String = "4") = MatchOfLog(event, "Qualification", number)
        at("MILLC").isSameAs(at("OHCL")) shouldBe null
        at("Mill Creek Regional").isSameAs(at("Buckeye Regional")) shouldBe null
        at("MILLC").isSameAs(at("2026millc")) shouldBe true
        at("Mill Creek Regional").isSameAs(at("MILLC")) shouldBe true
        at(null).isSameAs(at("MILLC")) shouldBe true
        at("MILLC").isSameAs(at("OHCL", "5")) shouldBe false
    }

    test("a playoff is counted by the field, or named by its set and its match") {
        same("Elimination 5", "Semifinal 5-1") shouldBe true
        same("Semifinal 5-1", "Semifinal 5-1") shouldBe true
        same("Semifinal 5-1", "Semifinal 5-2") shouldBe false
        same("Elimination 5", "Elimination 6") shouldBe false
        // Before 2023, the field counted the matches of all pairs in turn.
        same("Elimination 5", "Quarterfinal 1-2") shouldBe null
        same("Qualification 5", "Qualification 5-1") shouldBe false
    }

    test("a final is not a semifinal, and has another number in the count of its playoff") {
        same("Final 1", "Semifinal 1") shouldBe false
        same("Final 1", "Semifinal 1-1") shouldBe false
        same("Final 1", "Quarterfinal 1") shouldBe false
        same("Semifinal 1", "Quarterfinal 1") shouldBe false
        same("Final 1", "Final 1") shouldBe true
        same("Final 1", "Final 2") shouldBe false
        same("Final 1", "Elimination 14") shouldBe null
        same("Final 1", "Elimination 1") shouldBe null
        same("Playoff 3", "Elimination 3") shouldBe true
        same("Playoff 3", "Elimination 4") shouldBe false
    }
})
