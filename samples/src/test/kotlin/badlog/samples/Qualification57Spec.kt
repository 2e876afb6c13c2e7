package badlog.samples

import badlog.core.recording.ProblemKind
import badlog.core.recording.Severity
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe

class Qualification57Spec : FunSpec({
    val view = viewOf("qualification-57.bag.gz")

    test("the gzip stream of Qualification 57 has no end, and no trailer") {
        Inflated(sampleFile("qualification-57.bag.gz").readBytes()).isWhole shouldBe false
    }

    test("only its last row is lost, after the end of the match") {
        view.problems.filter { it.severity != Severity.NOTE }.map { it.kind } shouldBe listOf(ProblemKind.ROW_CUT)
        view.xAxis.positions.last() shouldBeGreaterThan 155.0
    }

    test("the left encoder stands still after the hit, the right one does not") {
        view.samples("Drivetrain/Left Position", HIT + 0.02, 150.0).toSet().size shouldBe 1
        view.samples("Drivetrain/Right Position", HIT + 0.02, 150.0).toSet().size shouldBeGreaterThan 1000
        view.samples("Drivetrain/Left Output", HIT + 0.02, 150.0).max() shouldBeGreaterThan 0.8
    }

    test("the gyro is missing for a second, then drifts while the robot stands still") {
        view.samples("Drivetrain/Angle", HIT + 0.02, HIT + 1.2).all { it.isNaN() } shouldBe true
        view.topic("Drivetrain/Angle").counts.notFinite shouldBe 64
        val atRest = view.samples("Drivetrain/Angle", 156.0, 166.0)
        atRest.last() - atRest.first() shouldBeGreaterThan 12.0
        val before = view.samples("Drivetrain/Angle", 17.5, 19.0)
        before.max() - before.min() shouldBeLessThan 0.5
    }
})
