package badlog.signals.pose

import badlog.core.analysis.Series
import badlog.core.analysis.Span
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class TrailSpec : FunSpec({
    fun trail(x: List<Pair<Double, Double>>, y: List<Pair<Double, Double>>, scale: Double = 1.0): Trail {
        fun series(samples: List<Pair<Double, Double>>) = Series(samples.map { it.first }.toDoubleArray(), samples.map { it.second }.toDoubleArray())
        return trailOf(series(x), series(y), scale)
    }

    fun Trail.samples() = List(size) { Triple(times[it], x[it], y[it]) }

    test("topics of the same times are joined sample by sample") {
        trail(listOf(0.0 to 1.0, 1.0 to 2.0), listOf(0.0 to 5.0, 1.0 to Double.NaN), scale = 2.0).run {
            x.toList() shouldBe listOf(2.0, 4.0)
            y[0] shouldBe 10.0
            isPlace(1) shouldBe false
            xSpan shouldBe Span(2.0, 2.0)
        }
    }

    test("topics of different times are joined by the last value of each, once each has one") {
        trail(listOf(0.0 to 1.0, 2.0 to 2.0, 4.0 to 3.0), listOf(1.0 to 5.0, 2.0 to 6.0)).samples() shouldBe
            listOf(Triple(1.0, 1.0, 5.0), Triple(2.0, 2.0, 6.0), Triple(4.0, 3.0, 6.0))
    }

    test("a time before the first sample has no sample") {
        val trail = trail(listOf(1.0 to 1.0, 2.0 to 2.0), listOf(1.0 to 1.0, 2.0 to 2.0))
        listOf(0.5, 1.0, 1.5, 9.0, Double.NaN).map(trail::indexAt) shouldBe listOf(-1, 0, 0, 1, -1)
        (trail.startOf(Span(1.5, 3.0)) to trail.endOf(Span(1.5, 3.0))) shouldBe (1 to 2)
    }
})
