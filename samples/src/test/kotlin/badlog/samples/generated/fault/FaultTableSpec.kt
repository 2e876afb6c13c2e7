package badlog.samples.generated.fault

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe

/** Pairs of faults with causes so close that a sentence about one may also name the other. */
private val NEAR = setOf(
    // A radio without power is also a lost link.
    "link-loss" to "radio-power-loss",
    // If the log names motors by numbers, the sentence alone does not show which mechanism is jammed or weak.
    "seized-mechanism" to "intake-jam",
    "intake-jam" to "seized-mechanism",
    "seized-mechanism" to "module-steer-lags",
    "elevator-short" to "shooter-slow",
)

class FaultTableSpec : FunSpec({
    test("the table has at least thirty kinds of faults, each with causes, symptoms, signals and a meaning of its strength") {
        FAULTS.size shouldBeGreaterThan 29
        FAULTS.map { it.id }.toSet().size shouldBe FAULTS.size
        for (fault in FAULTS) {
            withClue("$fault") {
                fault.causes.shouldNotBeEmpty()
                fault.symptoms.shouldNotBeEmpty()
                fault.shownBy.shouldNotBeEmpty()
                fault.strength shouldNotBe ""
                fault.cause shouldNotBe ""
            }
        }
    }

    test("each cause that a log does not show has a reason, and some naming shows each cause") {
        for (fault in FAULTS) {
            withClue("$fault") {
                for (naming in Naming.entries) {
                    val sight = fault.sightIn(naming)
                    sight.reason.isEmpty() shouldBe (sight.visibility == Visibility.CAUSE)
                }
                Naming.entries.filter { fault.sightIn(it).visibility == Visibility.CAUSE }.shouldNotBeEmpty()
            }
        }
    }

    test("a fault's own cause is accepted") {
        FAULTS.filter { it.verdictOn(it.cause) != Verdict.CAUSE }.map { it.id }.shouldBeEmpty()
    }

    test("the cause of another fault is not accepted, except for similar faults") {
        val wrong = FAULTS.flatMap { fault -> FAULTS.filter { it !== fault && fault.verdictOn(it.cause) == Verdict.CAUSE }.map { fault.id to it.id } }
        (wrong - NEAR).shouldBeEmpty()
    }

    test("a phrase is found in any order and by the beginnings of words, if all of its words occur") {
        val phrase = Phrase("battery old|weak")
        phrase.isIn("A weaker than usual BATTERY.") shouldBe true
        phrase.isIn("The battery is low.") shouldBe false
        phrase.isIn("An old radio.") shouldBe false
        Phrase("can wire").isIn("It scans wires.") shouldBe false
    }
})
