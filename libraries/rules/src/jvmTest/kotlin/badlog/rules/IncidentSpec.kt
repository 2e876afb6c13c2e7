package badlog.rules

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.incident.Incident
import badlog.rules.incident.evidenceOf
import badlog.rules.incident.incidentsIn
import badlog.rules.incident.nextOf
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

private fun found(rule: String, from: Double, to: Double = from + 0.5, topic: String? = null, severity: Severity = Severity.WARNING) = Finding(rule, severity, topic, "$rule.", from, listOf(Span(from, to)), 1, "s")

private fun ofWhole(rule: String) = Finding(rule, Severity.WARNING, null, "$rule.", Double.NaN, emptyList(), 1, "s")

private fun incidents(vararg findings: Finding): List<Incident> = RuleSet.BUILT_IN_PROVEN.incidentsIn(findings.toList())

private fun names(vararg findings: Finding) = incidents(*findings).map { it.name }

private const val PUSHED = "The robot pushed against something that did not move"
private const val BLOCKED = "A motor was blocked"

class IncidentSpec : FunSpec({
    val left = found("Motor stalled", 20.0, 22.0, "Drive/Left/Output")
    val right = found("Motor stalled", 20.1, 22.0, "Drive/Right/Output")

    test("an incident's name has the signals that were unusual at the same time") {
        fun blocked(from: Double, vararg signals: String) = Finding("Loop blocked", Severity.ERROR, null, "Blocked.", from, listOf(Span(from, from)), 1, "s", meanwhile = signals.toList())
        names(blocked(20.0)) shouldBe listOf("The loop stood still")
        names(blocked(20.0, "vision latency", "CPU load")) shouldBe listOf("The loop stood still while vision latency and CPU load rose")
    }

    test("a cause and its effects, even indirect ones, are one incident, the cause first") {
        val browned = found("Browned out", 21.5, severity = Severity.ERROR)
        val incident = incidents(found("Low battery", 21.0), browned, left, found("Main breaker", 21.0), right).single()
        incident.name shouldBe PUSHED
        incident.severity shouldBe Severity.ERROR
        incident.time shouldBe 20.0
        incident.causes.map { it.rule } shouldBe listOf("Motor stalled", "Motor stalled")
        incident.effects.map { it.rule } shouldBe listOf("Low battery", "Main breaker", "Browned out")
        incident.sentences.map { it.text } shouldBe listOf(
            "Likely cause: the robot pushed against something that did not move. Motor stalled.",
            "1 s later: Low battery.",
            "1.5 s later: Browned out.",
        )
        incident.sentences[2].finding shouldBe browned
        incident.others.map { it.rule } shouldBe listOf("Main breaker")
    }

    test("the findings that showed a cause are not repeated among the incident's sentences") {
        val loop = Finding("Loop blocked", Severity.ERROR, "Loop Time", "The loop took 396 ms.", 20.0, listOf(Span(20.0, 20.2)), 1, "s")
        val vision = Finding(
            "Loop and vision late together", Severity.WARNING, "Vision/Latency", "Late.", 20.0, listOf(Span(20.0, 20.2)), 1, "s",
            evidence = listOf("Loop Time", "Vision/Latency"),
        )
        val incident = incidents(loop, vision).single()
        incident.sentences.map { it.finding.rule } shouldBe listOf("Loop and vision late together")
        incident.effects.map { it.rule } shouldBe listOf("Loop blocked")
        incident.severity shouldBe Severity.ERROR
    }

    test("a finding much later, or before, is not an effect") {
        incidents(left, right, found("Browned out", 26.0), found("Low battery", 10.0)).single().effects.shouldBeEmpty()
    }

    test("effects without a cause in the log are not an incident") {
        names(found("Browned out", 20.0), found("Low battery", 20.0), found("Weak battery", 20.0)).shouldBeEmpty()
    }

    test("one side of a drivetrain that stands still is neither a push nor a blocked motor; two at different times are not a push") {
        names(left).shouldBeEmpty()
        names(left, found("Motor stalled", 40.0, 41.0, "Drive/Right/Output")).shouldBeEmpty()
        names(found("Motor stalled", 20.0, topic = "Arm/Output")) shouldBe listOf(BLOCKED)
    }

    test("an effect of an earlier cause begins no incident of its own") {
        val arm = found("Motor stalled", 20.5, topic = "Arm/Output")
        names(found("Encoder frozen", 19.0, 26.0, "Arm/Position"), arm) shouldBe
            listOf("An encoder stopped reporting")
    }

    test("a finding about the whole log explains what happens at any time, and needs no time itself") {
        val incident = incidents(ofWhole("Raised battery resistance"), found("Weak battery", 30.0)).single()
        incident.name shouldBe "The battery was old or worn"
        incident.time shouldBe 30.0
        incidents(ofWhole("High battery resistance")).single().time.isNaN() shouldBe true
    }

    test("a cause that requires an effect is not one without it") {
        names(found("CAN errors", 20.0)).shouldBeEmpty()
        names(found("CAN errors", 20.0), found("Values frozen", 20.2)) shouldBe listOf("The CAN bus was interrupted")
    }

    test("the worst incident comes first") {
        names(found("Motor stalled", 10.0, topic = "Arm/Output"), found("Link lost", 50.0, severity = Severity.ERROR)) shouldBe
            listOf("The robot lost its radio or driver station", BLOCKED)
    }

    test("findings of hooks and of rules with the same name are kept apart") {
        val ofHook = Finding("Link lost", Severity.ERROR, null, "x", 1.0, listOf(Span(1.0, 2.0)), 1, "s", isOfHook = true)
        names(ofHook).shouldBeEmpty()
    }

    test("all rules that causes and effects name exist") {
        val rules = RuleSet.BUILT_IN_PROVEN.rules.mapTo(HashSet()) { it.name }
        val graph = RuleSet.BUILT_IN_PROVEN.causes
        val named = graph.causes.flatMap { it.shownBy + it.onlyWith } + graph.effects.flatMap { (rule, followers) -> followers + rule }
        (named.toSet() - rules).shouldBeEmpty()
    }

    test("a file adds causes and effects, and replaces causes of the same name") {
        val own = "[[cause]]\nname = \"$BLOCKED\"\nshown_by = [\"Jam\"]\nnext = \"Look.\"\n\n[leads_to]\nJam = [\"Browned out\"]\n"
        val rules = RulesFile.parse(own).rules
        val incident = rules.incidentsIn(listOf(found("Jam", 5.0), found("Browned out", 6.0))).single()
        incident.name shouldBe BLOCKED
        incident.next shouldBe "Look."
        incident.effects.map { it.rule } shouldBe listOf("Browned out")
        rules.incidentsIn(listOf(found("Motor stalled", 5.0, topic = "Arm/Output"))).shouldBeEmpty()
        checkNotNull(RuleSet.fromJson(rules.toJson())).toJson() shouldBe rules.toJson()
    }

    test("a finding of an incident shows the incident's evidence, one alone its own") {
        val own = "[[cause]]\nname = \"$BLOCKED\"\nshown_by = [\"Jam\"]\nnext = \"Look.\"\n\n[leads_to]\nJam = [\"Browned out\"]\n"
        val jam = found("Jam", 5.0)
        val brownout = found("Browned out", 6.0)
        val incident: Incident? = RulesFile.parse(own).rules.incidentsIn(listOf(jam, brownout)).single()
        val none: Incident? = null
        incident.nextOf(brownout) shouldBe "Look."
        none.nextOf(brownout) shouldBe brownout.next
        incident.evidenceOf(brownout).toSet() shouldBe (jam.evidence + brownout.evidence).toSet()
        none.evidenceOf(brownout) shouldBe brownout.evidence
    }

    test("a mistake in a cause is reported with its line") {
        shouldThrow<RulesException> { RulesFile.parse("[[cause]]\nname = \"A\"\n") }.message shouldContain "This cause has no “shown_by”."
        shouldThrow<RulesException> { RulesFile.parse("[[cause]]\nname = \"A\"\nshown_by = \"B\"\ntogether = 0\n") }.message shouldContain
            "Line 4: “together” is how many"
    }
})
