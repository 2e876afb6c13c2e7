package badlog.charts.kind

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe

class TheilSenLineSpec : FunSpec({
    test("a few outliers do not turn the line") {
        val x = (1..20).map { it.toDouble() }
        val y = x.map { if (it in 18.0..19.0) 0.0 else 12 - 0.1 * it }
        val line = checkNotNull(TheilSenLine.through(x, y))
        line.slope shouldBe (-0.1 plusOrMinus 1e-9)
        line.at(10.0) shouldBe (11.0 plusOrMinus 1e-9)
    }

    test("thousands of points have the right line") {
        val x = List(20_000) { (it * 7919 % 20_000).toDouble() }
        TheilSenLine.through(x, x.map { 3 * it - 1 })!!.run { slope to at(0.0) } shouldBe (3.0 to -1.0)
    }

    test("calculating a line can be interrupted") {
        Thread.currentThread().interrupt()
        shouldThrow<InterruptedException> { TheilSenLine.through(listOf(1.0, 2.0), listOf(1.0, 2.0)) }
    }

    test("points above each other have no line") {
        TheilSenLine.through(listOf(1.0, 1.0), listOf(1.0, 2.0)) shouldBe null
    }

    test("a line ends at the edge of a chart") {
        val falling = checkNotNull(TheilSenLine.through(listOf(0.0, 10.0), listOf(20.0, 0.0)))
        falling.within(0.0..10.0, 4.0..16.0) shouldBe (2.0 to 8.0)
        falling.within(0.0..10.0, -50.0..50.0) shouldBe (0.0 to 10.0)
        falling.within(0.0..10.0, 30.0..50.0) shouldBe null
    }

    test("quartiles are interpolated between values") {
        Quartiles.of(listOf(4.0, 1.0, 2.0, 3.0)).run { listOf(lower, median, upper) } shouldBe listOf(1.75, 2.5, 3.25)
        Quartiles.of(listOf(7.0)).run { listOf(lower, median, upper) } shouldBe listOf(7.0, 7.0, 7.0)
    }
})
