package badlog.samples

import badlog.core.analysis.LogView
import badlog.core.recording.ProblemKind
import badlog.core.recording.Severity
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeSorted
import io.kotest.matchers.doubles.shouldBeBetween
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith

class Qualification42Spec : FunSpec({
    val view = viewOf("qualification-42.bag")

    test("is a match of 150 s at 50 Hz with some 50 topics") {
        view.title shouldBe "Mill Creek Regional Qualification 42"
        view.recording.topics.size shouldBe 51
        view.xAxis.title shouldBe "Time (s)"
        view.topic("System/Enabled").samples.count { it == 1.0 } shouldBeGreaterThan 7400
    }

    test("has no problems but notes on truth values and an unseen target") {
        view.problems.filter { it.severity != Severity.NOTE } shouldBe emptyList()
        (view.problems.map { it.kind }.toSet() - ProblemKind.TRUTH_VALUES - ProblemKind.EMPTY_CELLS) shouldBe emptySet()
    }

    test("the battery holds until the push, then sags to a brownout 1:32 into the match") {
        view.samples("System/Battery Voltage", 0.0, PUSH_BEGINS).min() shouldBeGreaterThan 8.5
        view.samples("System/Browned Out", 0.0, PUSH_BEGINS).max() shouldBe 0.0
        view.samples("PDP/Total Current", PUSH_BEGINS + 1, 93.6).min() shouldBeGreaterThan 200.0
        val first = view.events().first { "brownout" in it.second }.first
        (first - MATCH_BEGINS).shouldBeBetween(91.5, 92.5, 0.0)
        view.samples("System/Battery Voltage", first - 0.01, first + 0.01).min() shouldBeLessThan 6.8
        view.samples("Drivetrain/Left Output", first, first + 0.1).toSet() shouldBe setOf(0.0)
        view.samples("System/Browned Out", 98.0, 155.0).max() shouldBe 0.0
    }

    test("the drivers push in high gear, while the compressor runs") {
        val gear = view.topic("Drivetrain/Gear").texts
        gear[gear.rows.indexOf(view.rowAt(93.0))] shouldBe "HIGH"
        view.samples("Pneumatics/Compressor On", PUSH_BEGINS, 93.0).min() shouldBe 1.0
    }

    test("the old battery has a higher resistance than the battery of the practice run") {
        resistance(view, until = 90.0) shouldBeGreaterThan 1.4 * resistance(viewOf("practice.bag"), until = 40.0)
    }

    test("a CAN timeout holds the elevator's position for a quarter of a second") {
        view.samples("Elevator/Position", 49.32, 49.55).toSet().size shouldBe 1
        view.events().single { "CAN timeout" in it.second }.first.shouldBeBetween(49.3, 49.5, 0.0)
    }

    test("a loop takes longer than 20 ms") {
        view.topic("System/Loop Time").samples.max() shouldBeGreaterThan 120.0
        view.events().single { "overrun" in it.second }.second shouldBe
            "WARN: loop overrun, \"Vision.update\" took 127 ms"
    }

    test("events are in the order of time, the first with a comma and quotes") {
        view.events().map { it.first }.shouldBeSorted()
        view.events().first().second shouldStartWith "Autonomous enabled: \"Two Piece, Left\","
    }
})

private const val MATCH_BEGINS = 2.0

/** Returns the slope of voltage over current, in Ω. */
private fun resistance(view: LogView, until: Double): Double {
    val amps = view.samples("PDP/Total Current", 0.0, until)
    val volts = view.samples("System/Battery Voltage", 0.0, until)
    val meanAmps = amps.average()
    val meanVolts = volts.average()
    val together = amps.indices.sumOf { (amps[it] - meanAmps) * (volts[it] - meanVolts) }
    return -together / amps.sumOf { (it - meanAmps) * (it - meanAmps) }
}
