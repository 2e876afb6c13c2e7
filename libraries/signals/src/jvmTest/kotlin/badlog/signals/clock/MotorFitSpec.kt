package badlog.signals.clock

import badlog.core.analysis.LogView
import badlog.core.recording.Topic
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.withSignals
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe

class MotorFitSpec : FunSpec({
    val signals = RuleSet.BUILT_IN.signals

    /** A motor driven in each of [spans], sampled every 20 ms for 30 s, by a clock that began [later]. */
    fun output(name: String, spans: List<ClosedRange<Double>>, later: Double = 0.0, level: Double = 0.5): Topic = numbers(name, List(1500) { it / 50.0 }.map { time -> time - later to if (spans.any { time in it }) level else 0.0 })

    fun view(vararg topics: Topic): LogView = LogView.of(logOf(topics.toList())).withSignals(signals, "log")

    val arm = listOf(3.0..5.0, 7.0..8.5, 12.0..20.0)
    val wheel = listOf(2.0..9.0, 11.0..13.0, 14.5..21.0)

    test("a log of motor controllers is aligned with a motor of the robot's log that was driven at the same times, whatever its name") {
        val revlog = view(output("REV/Spark-3/APPLIED_OUTPUT", wheel, 1.3), output("REV/Spark-7/APPLIED_OUTPUT", arm, 1.3))
        val fit = checkNotNull(motorFit(revlog, view(output("Arm/Applied Output", arm)), signals))
        fit.edges shouldBe 6
        fit.seconds shouldBe (1.3 plusOrMinus 1e-6)
        fit.error shouldBe (0.0 plusOrMinus 1e-6)
    }

    test("volts in the robot's log work as well, and reversing is not an end") {
        val turning = listOf(3.0..4.0, 4.1..5.0, 7.0..8.5, 12.0..20.0)
        val revlog = view(output("REV/Spark-7/APPLIED_OUTPUT", turning, -0.4))
        val fit = checkNotNull(motorFit(revlog, view(output("Arm/Applied Volts", arm, level = 6.0)), signals))
        fit.edges shouldBe 6
        fit.seconds shouldBe (-0.4 plusOrMinus 1e-6)
    }

    test("without a motor's output in the robot's log, a motor that is driven until the robot is disabled shows the alignment") {
        val robot = view(flag("DS:enabled", 0.0, listOf(2.0, 9.0, 11.0, 21.0), 30.0))
        val revlog = view(output("REV/Spark-3/APPLIED_OUTPUT", listOf(2.1..8.98, 12.0..20.98), 1.0))
        val fit = checkNotNull(motorFit(revlog, robot, signals))
        fit.edges shouldBe 3
        fit.seconds shouldBe (1.0 plusOrMinus 0.06)
    }

    test("if nothing was driven, or nothing fits, there is no alignment") {
        val robot = view(output("Arm/Applied Output", arm))
        motorFit(view(output("REV/Spark-3/APPLIED_OUTPUT", emptyList())), robot, signals).shouldBeNull()
        motorFit(view(output("REV/Spark-3/APPLIED_OUTPUT", listOf(3.0..4.0))), robot, signals).shouldBeNull()
    }
})
