package badlog.rules

import badlog.rules.comparison.compared
import badlog.rules.number.LogNumbers
import badlog.rules.number.Measure
import badlog.rules.number.NumberKey
import badlog.signals.match.MatchKind
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.random.Random

private const val LEFT = "Drive/Front Left/Current"

private val KEYS = listOf(
    NumberKey("motor current", LEFT, Measure.DRIVING, "A"),
    NumberKey("motor current", LEFT, Measure.TELEOP, "A"),
    NumberKey("motor current", "Arm/Current", Measure.TELEOP, "A"),
    NumberKey("battery", "Battery Voltage", Measure.LOWEST, "V"),
    NumberKey(NumberKey.RESISTANCE, "Battery Voltage", Measure.RESISTANCE, "mΩ"),
)

private val USUAL = doubleArrayOf(16.7, 12.0, 4.0, 9.2, 15.0)

/** A log with usual numbers, each within a twentieth, except those in [others]. */
private fun log(random: Random, vararg others: Pair<Int, Double>, kind: MatchKind = MatchKind.MATCH): LogNumbers {
    val values = DoubleArray(USUAL.size) { USUAL[it] * (0.95 + 0.1 * random.nextDouble()) }
    for ((number, value) in others) values[number] = value
    return LogNumbers(kind, KEYS, values, 0.8)
}

private fun logs(count: Int, kind: MatchKind = MatchKind.MATCH) = Random(7).let { random -> List(count) { log(random, kind = kind) } }

private val odd = log(Random(1), 0 to 23.1)

class ComparisonSpec : FunSpec({
    fun texts(logs: List<LogNumbers>, rules: RuleSet = RuleSet.BUILT_IN) = rules.compared(logs).map { log -> log.findings.map { it.text } }

    test("a number far from the other matches is found, in its phase, with its unit and theirs") {
        val found = texts(logs(12) + odd)
        found.last().single() shouldContain Regex("$LEFT while driving was 23.1 A, [34][0-9] % above your 12 other matches \\(usually 1[67](.\\d)? A\\)\\.")
        found.dropLast(1).flatten().shouldBeEmpty()
    }

    test("a finding has its topic as evidence, and no time") {
        val finding = RuleSet.BUILT_IN.compared(logs(12) + odd).last().findings.single()
        finding.topic shouldBe LEFT
        finding.evidence shouldBe listOf(LEFT)
        finding.time.isNaN() shouldBe true
    }

    test("a log is not compared with four other logs, or with five if four are of another kind") {
        texts(logs(4) + odd).flatten().shouldBeEmpty()
        texts(logs(4) + logs(8, MatchKind.PRACTICE) + odd).flatten().shouldBeEmpty()
        texts(logs(5) + log(Random(1), 0 to 80.0)).flatten().size shouldBe 1
    }

    test("an outlier among the others hides no difference, and makes no finding in them") {
        val crazy = LogNumbers(MatchKind.MATCH, KEYS, DoubleArray(KEYS.size) { 1e6 }, 0.8)
        val found = texts(logs(6) + crazy + logs(6) + odd)
        found.last().size shouldBe 1
        found.filterIndexed { i, _ -> i != 6 && i != 13 }.flatten().shouldBeEmpty()
    }

    test("a topic has one finding, however many of its numbers differ, and a log at most three") {
        texts(logs(12) + log(Random(1), 0 to 40.0, 1 to 30.0)).last().size shouldBe 1
        val all = log(Random(1), 0 to 60.0, 1 to 60.0, 2 to 40.0, 3 to 3.0, 4 to 40.0)
        val found = RuleSet.BUILT_IN.compared(logs(12) + all).last().findings
        found.size shouldBeLessThanOrEqual 4
        found.count { it.rule == "Unlike other matches" } shouldBeLessThanOrEqual 3
    }

    test("three motors that differ alike were driven harder; two may be on one gearbox") {
        fun motors(random: Random, share: Double, count: Int) = LogNumbers(
            MatchKind.MATCH,
            List(4) { NumberKey("motor current", "Drive/$it/Current", Measure.TELEOP, "A") },
            DoubleArray(4) { 12 * (0.95 + 0.1 * random.nextDouble()) * if (it < count) share else 1.0 },
            0.8,
        )
        val others = Random(7).let { random -> List(12) { motors(random, 1.0, 0) } }
        texts(others + motors(Random(1), 1.8, 3)).flatten().shouldBeEmpty()
        texts(others + motors(Random(1), 1.8, 2)).last().size shouldBe 2
    }

    test("less than usual counts for a motor while the robot drives and for a battery, more than usual for the others") {
        texts(logs(20) + log(Random(1), 0 to 5.0)).last().single() shouldContain "below"
        texts(logs(20) + log(Random(1), 3 to 5.0)).last().single() shouldContain " V below your 20 other matches"
        texts(logs(20) + log(Random(1), 1 to 1.0, 2 to 0.0)).last().shouldBeEmpty()
        texts(logs(20) + log(Random(1), 3 to 12.0)).last().shouldBeEmpty()
    }

    test("the resistance of the battery is given with its uncertainty, and has to differ by more than that") {
        val found = RuleSet.BUILT_IN.compared(logs(12) + log(Random(1), 4 to 26.0)).last().findings.single()
        found.text shouldContain "Battery and wiring had a resistance of 26 ± 0.8 mΩ, "
        val unsure = LogNumbers(MatchKind.MATCH, KEYS, USUAL.copyOf().also { it[4] = 26.0 }, 9.0)
        texts(logs(12) + unsure).last().shouldBeEmpty()
    }

    test("rules that compare are switched off and limited like others") {
        fun rules(more: String) = RulesFile.parse("extends = \"default\"\n$more").rules
        texts(logs(12) + odd, rules("off = [\"comparison\"]")).flatten().shouldBeEmpty()
        texts(logs(12) + odd, rules("[limits]\n\"Unlike other matches\" = { percent = 60 }")).flatten().shouldBeEmpty()
        shouldThrow<RulesException> { rules("[limits]\n\"Unlike other matches\" = { much = 60 }") }.message shouldContain
            "deviations, percent, findings, others"
    }

    test("comparing a signal without numbers is a mistake") {
        val limits = "limits = { deviations = 5, percent = 25, findings = 3, others = 5 }"
        val rule = "[[comparison]]\nname = \"A\"\nseverity = \"note\"\nof = [\"setpoint\"]\n$limits\ntext = \"t\"\n"
        shouldThrow<RulesException> { RulesFile.parse(rule) }.message shouldContain
            "“setpoint” cannot be compared; use one of: battery"
    }
})
