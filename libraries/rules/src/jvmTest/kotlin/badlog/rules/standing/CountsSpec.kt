package badlog.rules.standing

import badlog.core.recording.Severity
import badlog.rules.BUILT_IN
import badlog.rules.COUNTS
import badlog.rules.LOOP_TIME
import badlog.rules.PLANTED
import badlog.rules.RuleSet
import badlog.rules.RulesFile
import badlog.rules.TestMatch
import badlog.rules.builtInRulesFromToml
import badlog.rules.countedTrust
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
        val proven = RuleSet.BUILT_IN.rules.first { it.standing == Standing.PROVEN }.name
        countedTrust(proven, hashes.getValue(proven)) shouldBe PROVEN_TRUST
        countedTrust(proven, "00000000") shouldBe UNCOUNTED_TRUST
    }

    test("each rule's hash is its own, and the same with another system's line ends") {
        hashes.values.toSet().size shouldBe hashes.size
        hashOfJson("{\r\n  \"name\": \"A\"\r\n}") shouldBe hashOfJson("{\n  \"name\": \"A\"\n}")
    }

    test("a built-in rule on trial is a note, whatever its severity once proven") {
        val proven = builtInRulesFromToml { _, _ -> PROVEN_TRUST }
        val trial = builtInRulesFromToml { _, _ -> UNCOUNTED_TRUST }
        trial.rules.forAll { it.severity to it.standing shouldBe (Severity.NOTE to Standing.ON_TRIAL) }
        proven.rules.first { it.name == "Low battery" }.run { severity to standing } shouldBe (Severity.ERROR to Standing.PROVEN)
        RuleSet.BUILT_IN.rules.first { it.name == "Low battery" }.trust shouldBe countedTrust("Low battery", hashes.getValue("Low battery"))
    }

    test("a rule on trial begins no incident") {
        fun incidents(onTrial: String): List<String> {
            val rules = builtInRulesFromToml { name, _ -> if (name == onTrial) UNCOUNTED_TRUST else PROVEN_TRUST }
            val findings = rules.over(TestMatch().apply { within(20.0..21.0, LOOP_TIME) { "250" } }.view(), "test.bag").findings
            findings.map { it.rule } shouldContain "Loop blocked"
            return rules.incidentsIn(findings).map { it.name }
        }
        incidents(onTrial = "") shouldContain "The loop stood still"
        incidents(onTrial = "Loop blocked") shouldNotContain "The loop stood still"
    }

    test("of findings with the same severity, the most trusted rules come first") {
        val rules = builtInRulesFromToml { name, _ -> if (name == "Weak battery") 0.9 else 0.8 }
        val findings = rules.over(TestMatch().apply(PLANTED.getValue("Weak battery")).apply(PLANTED.getValue("Button held while disabled")).view(), "test.bag").findings
        findings.map { it.trust }.toSet() shouldBe setOf(0.9, 0.8)
        findings.worstFirst().map { it.trust }.let { it shouldBe it.sortedDescending() }
    }

    test("a silent rule has no findings until a team sets one of its limits") {
        val view = TestMatch().apply(PLANTED.getValue("Weak battery")).view()
        fun found(rules: RuleSet) = rules.over(view, "test.bag").findings.filter { it.rule == "Weak battery" }.map { it.severity }
        RuleSet.BUILT_IN.rules.first { it.name == "Weak battery" }.standing shouldBe Standing.SILENT
        found(RuleSet.BUILT_IN) shouldBe emptyList()
        found(RulesFile.parse("extends = \"default\"\n[limits]\n\"Weak battery\" = { volts = 9 }").rules) shouldBe listOf(Severity.NOTE)
    }

    test("a finding of a silent rule still silences the rules that follow from it") {
        fun found(trust: Double) = builtInRulesFromToml { name, _ -> if (name == "Values frozen") trust else PROVEN_TRUST }
            .over(TestMatch().apply(PLANTED.getValue("Values frozen")).view(), "test.bag").findings.map { it.rule }
        found(trust = 0.0) shouldBe found(PROVEN_TRUST) - "Values frozen"
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

    test("rules that are counted again keep the counts of other sets, and other rules keep theirs") {
        fun counts(rule: String, set: EvidenceSet, couldRun: Int) = RuleCounts(rule, "0a", set, couldRun, teams = 1, fired = 0, right = 0, wrong = 0, unknown = 0)
        val old = listOf(counts("a", EvidenceSet.REAL, 1), counts("a", EvidenceSet.THIRD, 1), counts("b", EvidenceSet.REAL, 1))
        val made = listOf(counts("a", EvidenceSet.REAL, 2))
        old.recounted(mapOf(EvidenceSet.REAL to made), setOf("a")) shouldBe old.drop(1) + made
        old.recounted(mapOf(EvidenceSet.REAL to emptyList()), setOf("a", "b")) shouldBe listOf(old[1])
    }

    test("all rules that are right about planted faults exist") {
        for (fault in listOf("brownout", "vision", "motor_overheats")) rightRulesFor(fault) shouldNotBe null
        rightRulesFor("none") shouldBe null
        ALL_RIGHT.filter { it !in hashes }.shouldBeEmpty()
    }
})
