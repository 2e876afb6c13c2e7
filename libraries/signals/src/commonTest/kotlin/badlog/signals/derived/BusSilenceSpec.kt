package badlog.signals.derived

import badlog.core.analysis.Series
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe

class BusSilenceSpec : FunSpec({
    val times = timesFor(20)
    val other = times.series { 1.0 }

    fun without(from: Double, to: Double, value: (Double) -> Double = { 0.0 }): Series {
        val kept = times.filter { it !in from..to }.toDoubleArray()
        return kept.series(value)
    }

    fun silence(own: Series, others: List<Series> = listOf(other, other), isEnabled: (Double) -> Boolean = { true }) = busSilence(listOf(own), others, isEnabled).most()

    test("a device that does not answer while others do is silent, for as long as that lasts") {
        silence(without(10.0, 12.0)) shouldBe (2.04 plusOrMinus 1e-6)
        silence(without(15.0, 99.0)) shouldBe 5.0
        silence(other) shouldBe 0.0
    }

    test("a log that stands still, or a disabled robot, shows nothing about a device") {
        silence(without(10.0, 12.0), listOf(without(10.0, 12.0), without(10.0, 12.0))) shouldBe 0.0
        silence(without(10.0, 12.0), isEnabled = { false }) shouldBe 0.0
    }

    test("in a log of changes, silence means that nothing changed") {
        silence(without(10.0, 12.0) { it }).isNaN() shouldBe true
    }

    test("empty cells are silence, too") {
        silence(times.series { if (it in 10.0..12.0) Double.NaN else 0.0 }) shouldBe (2.04 plusOrMinus 1e-6)
    }
})
