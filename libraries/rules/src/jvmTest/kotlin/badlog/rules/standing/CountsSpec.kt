package badlog.rules.standing

import badlog.core.recording.Severity
import badlog.rules.BUILT_IN
import badlog.rules.COUNTS
import badlog.rules.LOOP_TIME
import badlog.rules.PLANTED
import badlog.rules.RuleSet
import badlog.rules.TestMatch
import badlog.rules.builtInRulesFromToml
import badlog.rules.countedStanding
import badlog.rules.field.Judgement
import badlog.rules.hashOfJson
import badlog.rules.hashesOfBuiltInRules
import badlog.rules.incident.incidentsIn
import badlog.rules.over
import badlog.rules.worstFirst
import io.kotest.core.spec.style.FunSpec
import io.kotest.inspectors.forAll
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe

class CountsSpec : FunSpec({
    val hashes = hashesOfBuiltInRules()

    test("the table names existing rules only, each once for a set") {
        (COUNTS.map { it.rule }.toSet() - hashes.keys).shouldBeEmpty()
        COUNTS.groupBy { it.rule to it.set }.filterValues { it.size > 1 }.keys.shouldBeEmpty()
    }

    test("counts of another text of a rule do not count for it") {
        val proven = RuleSet.BUILT_IN.rules.first { !it.isOnTrial }.name
        countedStanding(proven, hashes.getValue(proven)) shouldBe Standing.PROVEN
        countedStanding(proven, "00000000") shouldBe Standing.ON_TRIAL
    }

    test("each rule's hash is its own, and the same with another system's line ends") {
        hashes.values.toSet().size shouldBe hashes.size
        hashOfJson("{\r\n  \"name\": \"A\"\r\n}") shouldBe hashOfJson("{\n  \"name\": \"A\"\n}")
    }

    test("a built-in rule on trial is a note, whatever its severity once proven") {
        val proven = builtInRulesFromToml { _, _ -> Standing.PROVEN }
        val trial = builtInRulesFromToml { _, _ -> Standing.ON_TRIAL }
        trial.rules.forAll { it.severity to it.isOnTrial shouldBe (Severity.NOTE to true) }
        proven.rules.first { it.name == "Low battery" }.run { severity to isOnTrial } shouldBe (Severity.ERROR to false)
        checkNotNull(RuleSet.BUILT_IN.rules.find { it.name == "Low battery" }).isOnTrial shouldBe
            (countedStanding("Low battery", hashes.getValue("Low battery")) == Standing.ON_TRIAL)
    }

    test("a rule on trial begins no incident") {
        fun incidents(onTrial: String): List<String> {
            val rules = builtInRulesFromToml { name, _ -> if (name == onTrial) Standing.ON_TRIAL else Standing.PROVEN }
            val findings = rules.over(TestMatch().apply { within(20.0..21.0, LOOP_TIME) { "250" } }.view(), "test.bag").findings
            findings.map { it.rule } shouldContain "Loop blocked"
            return rules.incidentsIn(findings).map { it.name }
        }
        incidents(onTrial = "") shouldContain "The loop stood still"
        incidents(onTrial = "Loop blocked") shouldNotContain "The loop stood still"
    }

    test("of findings of the same severity, those of rules on trial come last") {
        val rules = builtInRulesFromToml { name, _ -> if (name == "Weak battery") Standing.PROVEN else Standing.ON_TRIAL }
        val findings = rules.over(TestMatch().apply(PLANTED.getValue("Weak battery")).apply(PLANTED.getValue("Button held while disabled")).view(), "test.bag").findings
        findings.map { it.isOnTrial }.toSet() shouldBe setOf(true, false)
        findings.worstFirst().map { it.isOnTrial }.let { it shouldBe it.sorted() }
    }

    test("findings are counted for each rule, with logs and teams where it could run") {
        fun found(judgement: Judgement?) = JudgedFinding("Low battery", "The battery voltage dropped.", judgement)
        val logs = listOf(
            JudgedLog("a", "254", setOf("Low battery"), listOf(found(Judgement.TRUE), found(null))),
            JudgedLog("b", "254", setOf("Low battery"), listOf(found(Judgement.FALSE))),
            JudgedLog("c", "118", emptySet(), listOf(found(Judgement.UNKNOWN))),
        )
        countsOf(EvidenceSet.REAL, logs, mapOf("Low battery" to "0a", "Weak battery" to "0b")) shouldBe
            listOf(RuleCounts("Low battery", "0a", EvidenceSet.REAL, couldRun = 2, teams = 1, fired = 4, right = 1, wrong = 1, unknown = 1))
    }

    test("all rules that are right about planted faults exist") {
        for (fault in listOf("brownout", "vision", "motor_overheats")) rightRulesFor(fault) shouldNotBe null
        rightRulesFor("none") shouldBe null
        ALL_RIGHT.filter { it !in hashes }.shouldBeEmpty()
    }
})
