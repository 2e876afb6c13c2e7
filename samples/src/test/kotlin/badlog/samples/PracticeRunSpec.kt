package badlog.samples

import badlog.core.recording.ProblemKind
import badlog.core.recording.Severity
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.doubles.shouldBeBetween
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe

class PracticeRunSpec : FunSpec({
    val view = viewOf("practice.bag")

    test("ends in the middle of a row") {
        sampleFile("practice.bag").readBytes().last() shouldNotBe '\n'.code.toByte()
        val cells = sampleFile("practice.bag").readText().substringAfterLast('\n').count { it == ',' } + 1
        cells shouldBeLessThan view.recording.topics.size
    }

    test("a page of it is NULs") {
        sampleFile("practice.bag").readBytes().count { it == 0.toByte() } shouldBe 4096
    }

    test("has no problems other than its two damaged places") {
        // The hole cuts the row before it and the row after it.
        view.problems.filter { it.severity != Severity.NOTE }.map { it.kind } shouldContainExactlyInAnyOrder
            listOf(ProblemKind.NUL_HOLE, ProblemKind.ROW_CUT, ProblemKind.ROW_CUT, ProblemKind.ROW_CUT)
    }

    test("the power is cut without a sag, after the lead worked loose") {
        val last = view.xAxis.positions.last()
        last.shouldBeBetween(45.3, 45.4, 0.0)
        view.samples("System/Battery Voltage", last - 0.5, last).min() shouldBeGreaterThan 11.5
        val current = view.samples("PDP/Total Current", 42.8, 43.0)
        val volts = view.samples("System/Battery Voltage", 42.8, 43.0)
        // The voltage falls without more current.
        volts.max() - volts.min() shouldBeGreaterThan 1.5
        current.last() shouldBeLessThan current.first()
    }
})
