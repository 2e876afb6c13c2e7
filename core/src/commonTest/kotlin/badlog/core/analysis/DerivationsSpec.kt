package badlog.core.analysis

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe

private const val GAP = Double.NaN

private fun series(vararg samples: Pair<Double, Double>) = Series(DoubleArray(samples.size) { samples[it].first }, DoubleArray(samples.size) { samples[it].second })

private fun Series.pairs() = x.zip(y)

// As text, because a gap does not equal a gap.
private fun DoubleArray.shown() = joinToString()

class DerivationsSpec : FunSpec({
    // Worked out by hand: y = 1, 3, 2, 2 at x = 0, 1, 3, 4.
    val worked = series(0.0 to 1.0, 1.0 to 3.0, 3.0 to 2.0, 4.0 to 2.0)

    test("delta is the difference between neighbors, at their midpoint") {
        worked.delta().pairs() shouldBe listOf(0.5 to 2.0, 2.0 to -1.0, 3.5 to 0.0)
    }

    test("derivative is the slope between neighbors, at their midpoint") {
        worked.derivative().pairs() shouldBe listOf(0.5 to 2.0, 2.0 to -0.5, 3.5 to 0.0)
    }

    test("integral is the running trapezoid sum, 0 at the first sample") {
        worked.integral().pairs() shouldBe listOf(0.0 to 0.0, 1.0 to 2.0, 3.0 to 7.0, 4.0 to 9.0)
    }

    test("a series of one sample has no delta and no derivative, and an integral of 0") {
        val one = series(2.0 to 5.0)
        one.delta().size shouldBe 0
        one.derivative().size shouldBe 0
        one.integral().pairs() shouldBe listOf(2.0 to 0.0)
        series().integral().size shouldBe 0
    }

    test("a gap makes neighboring derivations gaps, and adds no area to the integral") {
        val gappy = series(0.0 to 2.0, 1.0 to 2.0, 2.0 to GAP, 3.0 to 4.0, 4.0 to 4.0)
        gappy.delta().y.shown() shouldBe doubleArrayOf(0.0, GAP, GAP, 0.0).shown()
        gappy.derivative().y.shown() shouldBe doubleArrayOf(0.0, GAP, GAP, 0.0).shown()
        gappy.integral().y.shown() shouldBe doubleArrayOf(0.0, 2.0, GAP, 2.0, 6.0).shown()
    }

    test("if x repeats or goes backwards, the derivative is a gap and the integral adds no area") {
        val clockSet = series(5.0 to 1.0, 6.0 to 3.0, 6.0 to 9.0, 0.0 to 9.0, 1.0 to 11.0)
        clockSet.derivative().y.shown() shouldBe doubleArrayOf(2.0, GAP, GAP, 2.0).shown()
        clockSet.delta().y.shown() shouldBe doubleArrayOf(2.0, 6.0, 0.0, 2.0).shown()
        clockSet.integral().y.shown() shouldBe doubleArrayOf(0.0, 2.0, 2.0, 2.0, 12.0).shown()
    }

    test("every derivation treats infinities as gaps") {
        val wild = series(0.0 to 1.0, 1.0 to Double.POSITIVE_INFINITY, 2.0 to 1.0)
        wild.delta().y.shown() shouldBe doubleArrayOf(GAP, GAP).shown()
        wild.derivative().y.shown() shouldBe doubleArrayOf(GAP, GAP).shown()
        wild.integral().y.shown() shouldBe doubleArrayOf(0.0, GAP, 0.0).shown()
    }

    test("an integral of a million small steps keeps its last digits") {
        val size = 1_000_001
        val steady = Series(DoubleArray(size) { it * 0.001 }, DoubleArray(size) { 0.1 })
        steady.integral().y.last() shouldBe (100.0 plusOrMinus 1e-12)
    }
})
