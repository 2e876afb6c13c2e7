package badlog.rules.standing

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

private val REAL = RuleCounts("Low battery", "0a1b2c3d", EvidenceSet.REAL, couldRun = 30, teams = 3, fired = 0, right = 0, wrong = 0, unknown = 0)
private val GENERATED = RuleCounts("Low battery", "0a1b2c3d", EvidenceSet.GENERATED, couldRun = 500, teams = 0, fired = 3, right = 3, wrong = 0, unknown = 0)

class StandingSpec : FunSpec({
    fun lacking(vararg counts: RuleCounts) = lackingIn(counts.toList())

    test("thirty logs of three teams without a false finding, and three right ones in simulators, are just enough") {
        lacking(REAL, GENERATED) shouldBe emptyList()
        trustOf(listOf(REAL, GENERATED)) shouldBe PROVEN_TRUST
    }

    test("a rule that was never counted is on trial") {
        lacking() shouldBe listOf("its text was never counted")
        trustOf(emptyList()) shouldBe UNCOUNTED_TRUST
        Standing.of(UNCOUNTED_TRUST) shouldBe Standing.ON_TRIAL
    }

    test("a rule is silent once more than one in three of its judged findings were wrong, in whatever set") {
        fun standing(right: Int, wrong: Int) = Standing.of(trustOf(listOf(REAL.copy(fired = right, right = right), GENERATED.copy(fired = wrong, right = 0, wrong = wrong))))
        standing(right = 4, wrong = 2) shouldBe Standing.ON_TRIAL
        standing(right = 3, wrong = 2) shouldBe Standing.SILENT
        standing(right = 200, wrong = 100) shouldBe Standing.ON_TRIAL
        standing(right = 200, wrong = 101) shouldBe Standing.SILENT
        standing(right = 0, wrong = 1) shouldBe Standing.SILENT
    }

    test("of two unproven rules, the one that was right more often is trusted more") {
        val often = trustOf(listOf(REAL.copy(fired = 9, right = 9, wrong = 0), GENERATED.copy(fired = 1, right = 0, wrong = 1)))
        val seldom = trustOf(listOf(REAL.copy(fired = 1, right = 1, wrong = 0), GENERATED.copy(fired = 1, right = 0, wrong = 1)))
        (often > seldom && often < PROVEN_TRUST) shouldBe true
    }

    test("one log or one team less is too few") {
        lacking(REAL.copy(couldRun = 29), GENERATED) shouldBe listOf("29 of 30 real logs")
        lacking(REAL.copy(teams = 2), GENERATED) shouldBe listOf("logs of 2 of 3 teams")
    }

    test("a false finding in real logs is one too many, up to 199 logs; then one in 200 is allowed") {
        lacking(REAL.copy(couldRun = 199, fired = 1, wrong = 1), GENERATED) shouldBe listOf("1 false in 199 real logs")
        lacking(REAL.copy(couldRun = 200, fired = 1, wrong = 1), GENERATED) shouldBe emptyList()
        lacking(REAL.copy(couldRun = 399, fired = 2, wrong = 2), GENERATED) shouldBe listOf("2 false in 399 real logs")
    }

    test("a finding without a judgement proves nothing; one judged as unknown is judged") {
        lacking(REAL.copy(fired = 2, right = 1), GENERATED) shouldBe listOf("1 not judged")
        lacking(REAL.copy(fired = 2, right = 1, unknown = 1), GENERATED) shouldBe emptyList()
    }

    test("of the findings in all simulators together, 95 % have to be right") {
        val third = GENERATED.copy(set = EvidenceSet.THIRD, fired = 17, right = 16, wrong = 1)
        lacking(REAL, GENERATED, third) shouldBe emptyList()
        lacking(REAL, GENERATED.copy(fired = 2, right = 2), third) shouldBe listOf("18 of 19 right in simulators")
    }

    test("a rule that was right less than three times, over real logs and simulators, is on trial") {
        val two = GENERATED.copy(fired = 2, right = 2)
        lacking(REAL, two) shouldBe listOf("right 2 of 3 times")
        lacking(REAL.copy(fired = 1, right = 1), two) shouldBe emptyList()
        lacking(REAL) shouldBe listOf("right 0 of 3 times")
    }

    test("counts are read as they were written, and a line without counts is reported with its number") {
        val counts = listOf(REAL, GENERATED)
        ruleCountsIn(textOf(counts)) shouldBe counts
        for (row in listOf("Low battery\t0a\tmars\t1\t1\t1\t1\t1\t1", "Low battery\t0a\treal\t1\t1\t1\t1\t1", "Low battery\t0a\treal\t1\t1\t1\t1\t1\tx")) {
            shouldThrow<IllegalArgumentException> { ruleCountsIn(textOf(counts) + row) }.message shouldContain "Line 4 "
        }
    }
})
