package badlog.rules

import badlog.core.analysis.LogView
import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.signals.pose.PLAN_LIMIT
import badlog.signals.pose.PLAN_PATIENCE
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldNotBeEmpty
import kotlin.math.roundToInt

private const val LINKS = "[[linked]]\nmotors = [\"Drive/Left\", \"Drive/Right\"]\n"

/** Rules about the clock, which faults in cells cannot change. */
private val OF_CLOCK = listOf("Gap in time", "Clock set back")

private val OF_WHOLE_LOGS = listOf("Restarted in the match", "Ended in the match")

/** Returns [rule] of these rules with those that keep it silent: a slice asks about one rule, and all of them take four times as long. */
private fun RuleSet.only(rule: String): RuleSet {
    var wanted: Set<String>
    var next = setOf(rule)
    do {
        wanted = next
        next = wanted + rules.filter { it.name in wanted }.flatMap { it.unless }
    } while (next.size > wanted.size)
    return RuleSet(aliases, rules.filter { it.name in wanted }, signals, causes, comparisons, devices)
}

@Tags("InCheck")
class BuiltInRulesSpec : FunSpec({
    val rules = HEARD_RULES.with(RuleSet.BUILT_IN.signals.with(SignalsFile.parse(LINKS)))

    test("a healthy match has no finding") {
        TestMatch().findings(rules).map { "${it.rule}: ${it.text}" }.shouldBeEmpty()
    }

    test("each rule has a slice that it finds, one as near as possible that it must not find, a group, a reason and advice") {
        (PLANTED.keys + OF_CLOCK) shouldContainExactlyInAnyOrder rules.rules.map { it.name }
        NEAR_MISSES.keys shouldContainExactlyInAnyOrder PLANTED.keys
        for (rule in RulesReader(resource(RulesFile.NAME), rules.signals, isBuiltIn = true).read().rules.rules) {
            withClue(rule.name) {
                rule.group.shouldNotBeEmpty()
                rule.reason.shouldNotBeEmpty()
                rule.next.shouldNotBeEmpty()
            }
        }
    }

    for ((rule, plant) in PLANTED) {
        test("“$rule” is found where it was planted, with its evidence") {
            val match = TestMatch().apply(plant)
            val view = match.view()
            val result = rules.only(rule).over(view, "test.bag")
            result.skipped.filter { it.rule == rule }.map { it.toString() }.shouldBeEmpty()
            result.findings.map { it.rule } shouldContain rule
            val finding = result.findings.first { it.rule == rule }
            finding.next.shouldNotBeEmpty()
            finding.evidence.shouldNotBeEmpty()
            (finding.evidence - view.recording.topics.map { it.name }.toSet()).shouldBeEmpty()
        }
    }

    test("a camera that sees nothing for a while after a wrong picture is still usually right") {
        val match = TestMatch().apply(PLANTED.getValue("Vision jumps"))
        val view = match.view { time -> time.takeIf { (it * TestMatch.ROWS).roundToInt() % 400 !in 101..250 } }
        rules.over(view, "test.bag").findings.map { it.rule } shouldContain "Vision jumps"
    }

    for ((rule, plant) in NEAR_MISSES) {
        test("“$rule” is silent just short of it, though it ran") {
            val result = rules.only(rule).over(TestMatch().apply(plant).view(), "test.bag")
            result.skipped.filter { it.rule == rule }.map { it.toString() }.shouldBeEmpty()
            result.findings.filter { it.rule == rule }.map { it.text }.shouldBeEmpty()
        }
    }

    test("leaving the plan has the same limits on a path as in the rule") {
        rules.rules.first { it.name == "Left the plan" }.condition shouldBe "plan distance > $PLAN_LIMIT for $PLAN_PATIENCE s"
    }

    test("the finding for leaving the plan names the topics of both poses, and the distance") {
        val match = TestMatch().apply(PLANTED.getValue("Left the plan"))
        val finding = match.findings(rules).single { it.rule == "Left the plan" }
        finding.text shouldBe "The robot left its plan at 11 s, by up to 2.5 m."
        finding.evidence shouldBe listOf("Robot", "TrajectorySetpoint").flatMap { name -> listOf("x", "y").map { "Odometry/$name/translation/$it" } }
        // In teleop, the robot follows no plan.
        val byHand = TestMatch().apply { from(15.1, "Odometry/TrajectorySetpoint/translation/x") { ((it - 15) / 2).toString() } }
        byHand.findings(rules).map { it.rule }.shouldBeEmpty()
        rules.over(TestMatch().apply { without("Odometry/TrajectorySetpoint/translation/x") }.view(), "test.bag").skipped
            .single { it.rule == "Left the plan" }.message shouldBe "no topics for the robot's pose and its planned pose"
    }

    test("a part that was cut out of a log neither restarted nor ended in the match") {
        val match = TestMatch().apply { flag("/DriverStation/Enabled") { true } }
        val whole = rules.over(match.view(), "test.bag")
        whole.findings.map { it.rule }.filter { it in OF_WHOLE_LOGS } shouldBe OF_WHOLE_LOGS
        val recording = match.view().recording
        val part = rules.over(LogView.of(recording.copy(values = recording.values.ofPart("90 s to 130 s"))), "test.bag")
        part.findings.map { it.rule }.filter { it in OF_WHOLE_LOGS }.shouldBeEmpty()
        part.skipped.filter { it.rule in OF_WHOLE_LOGS }.map { it.message }.toSet() shouldBe
            setOf("the file is only part of a log")
    }

    test("a file that ends inside a record may only be a part of its log, whose start is known") {
        val view = TestMatch().apply { flag("/DriverStation/Enabled") { true } }.view()
        fun found(vararg kinds: ProblemKind): List<String> {
            val problems = kinds.map { Problem(it, "The file is damaged.") }
            return rules.over(LogView.of(view.recording.copy(problems = problems)), "test.bag").findings.map { it.rule }.filter { it in OF_WHOLE_LOGS }
        }
        found(ProblemKind.BLANK_LINE) shouldBe OF_WHOLE_LOGS
        for (kind in listOf(ProblemKind.RECORD_CUT, ProblemKind.LAST_CELL_CUT, ProblemKind.GZIP_CUT)) found(kind) shouldBe listOf("Restarted in the match")
        found(ProblemKind.HEADER_UNREADABLE).shouldBeEmpty()
    }

    test("a stop of the log is found, but not while the program starts, nor while the robot is disabled") {
        fun gaps(from: Double, to: Double) = rules.over(TestMatch().view { time -> time.takeIf { it !in from..to } }, "test.bag").findings.filter { it.rule == "Gap in time" }
        gaps(20.0, 21.0).map { it.text } shouldBe listOf("Nothing was logged for up to 1.04 s while the robot was enabled.")
        gaps(0.1, 1.0).shouldBeEmpty()
        gaps(2.5, 3.5).shouldBeEmpty()
        // A log of changes has many pauses.
        fun pauses(count: Int) = rules.over(TestMatch().view { time -> time.takeIf { it !in 20.0..35.0 || it % 3 < 2 || it > 20 + 3 * count } }, "test.bag").findings
        pauses(2).map { it.rule } shouldContain "Gap in time"
        pauses(3).map { it.rule } shouldNotContain "Gap in time"
    }

    test("a clock that was set back is found") {
        val view = TestMatch().view { if (it < 20) it else it - 10 }
        rules.over(view, "test.bag").findings.map { it.rule } shouldContain "Clock set back"
    }

    test("each text of an error is reported, however often others occur") {
        val match = TestMatch()
        val errors = (0..4).map { 20.0 + it to "ERROR: brownout" }
        match.event("messages", 10.0 to "WARN: CAN timeout; Elevator (ID 5)", *errors.toTypedArray())
        match.findings(rules).map { it.text } shouldContainExactlyInAnyOrder listOf(
            "messages at 10 s: WARN: CAN timeout; Elevator (ID 5)",
            "messages at 20 s (5×): ERROR: brownout",
        )
    }

    test("topics that do not fit cause neither findings nor problems") {
        val match = TestMatch()
        for (name in listOf(BATTERY, LOOP_TIME, "/SystemStats/CANBus/Utilization", "/SystemStats/BrownedOut")) {
            match.without(name)
            match.event(name, 1.0 to "a", 2.0 to "b")
        }
        val result = rules.over(match.view(), "test.bag")
        result.findings.map { it.rule }.shouldBeEmpty()
        result.skipped.filter { it.isMistake }.shouldBeEmpty()
    }
})
