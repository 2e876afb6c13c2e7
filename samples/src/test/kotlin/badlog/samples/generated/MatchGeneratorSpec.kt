package badlog.samples.generated

import badlog.samples.generated.fault.FAULTS
import badlog.samples.generated.fault.Naming
import badlog.samples.generated.fault.STRENGTHS
import badlog.samples.generated.robot.Hardship
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.comparables.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe

@Tags("InCheck")
class MatchGeneratorSpec : FunSpec({
    test("the same seed makes the same bytes, and another seed other bytes") {
        for (naming in Naming.entries) {
            val fault = FAULTS[naming.ordinal * 5]
            val match = GENERATOR.faulty(naming, fault, 1.0)
            (match.bytes contentEquals MatchGenerator(2026).faulty(naming, fault, 1.0).bytes) shouldBe true
            if (naming.ordinal == 0) (match.bytes contentEquals MatchGenerator(2027).faulty(naming, fault, 1.0).bytes) shouldBe false
        }
    }

    test("a short sequence has all namings, strengths, faults and hardships, and a third of healthy matches") {
        val some = GENERATOR.planned().take(FAULTS.size * 3).toList()
        val (healthy, faulty) = some.map { it.plan }.partition { it.fault == null }
        some.map { it.plan.naming }.toSet() shouldBe Naming.entries.toSet()
        faulty.mapNotNull { it.fault }.toSet() shouldBe FAULTS.toSet()
        faulty.map { it.strength }.toSet() shouldBe STRENGTHS.toSet()
        healthy.size shouldBe FAULTS.size
        some.map { it.name }.toSet().size shouldBe some.size
        healthy.count { it.hardship != Hardship.NONE } shouldBe FAULTS.size / 3
    }

    for (naming in Naming.entries) {
        test("logs of ${naming.id} without a fault are read without a problem") {
            // Each hardship in one naming; `EveryNamingSpec` tries all of them.
            for (i in 0..6) if (i % Naming.entries.size == naming.ordinal) read(GENERATOR.healthy(naming, i * 3 + 2))
        }

        // Each fault in one naming; `EveryNamingSpec` tries all of them.
        testFaults(naming, FAULTS.filterIndexed { index, _ -> index % Naming.entries.size == naming.ordinal })
    }

    test("the description of a match is JSON with the fault, its causes and its evidence") {
        val match = GENERATOR.faulty(Naming.ADVANTAGEKIT, FAULTS.first(), 0.3)
        val members = checkNotNull(badlog.core.json.JsonReader.readObject(describe(match))).associate { it.key to it.value }
        members.getValue("fault").text shouldBe FAULTS.first().id
        checkNotNull(members.getValue("evidence").items).map { it.text } shouldContainAll listOf("/SystemStats/BatteryVoltage")
        members.getValue("start").json.toDouble() shouldBe match.start
        match.name shouldNotBe GENERATOR.faulty(Naming.ADVANTAGEKIT, FAULTS.first(), 1.0).name
        match.bytes.size shouldBeGreaterThan 100_000
    }
})
