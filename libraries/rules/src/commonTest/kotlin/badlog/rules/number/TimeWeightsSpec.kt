package badlog.rules.number

import badlog.core.analysis.Series
import badlog.core.analysis.Span
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class TimeWeightsSpec : FunSpec({
    val x = doubleArrayOf(0.0, 1.0, 2.0, 5.0)

    test("a sample holds until the next, and counts for as long as it holds within the spans") {
        timeWithin(listOf(Span(0.5, 1.5), Span(3.0, 9.0)), x, end = 7.0).toList() shouldBe listOf(0.5, 0.5, 2.0, 2.0)
        timeWithin(emptyList(), x, end = 7.0).toList() shouldBe listOf(0.0, 0.0, 0.0, 0.0)
    }

    test("a mean is weighted by time, and gaps have no weight") {
        val series = Series(x, doubleArrayOf(10.0, Double.NaN, 40.0, 0.0))
        meanOf(series, doubleArrayOf(1.0, 5.0, 3.0, 0.0), least = 1.0) shouldBe 32.5
        meanOf(series, doubleArrayOf(1.0, 5.0, 3.0, 0.0), least = 5.0).isNaN() shouldBe true
    }

    test("spans that overlap or follow each other closely are merged; two lists are intersected") {
        united(listOf(Span(3.0, 4.0), Span(0.0, 1.0), Span(1.2, 2.0), Span(0.2, 0.4)), gap = 0.3) shouldBe listOf(Span(0.0, 2.0), Span(3.0, 4.0))
        common(listOf(Span(0.0, 2.0), Span(3.0, 4.0)), listOf(Span(1.0, 3.5))) shouldBe listOf(Span(1.0, 2.0), Span(3.0, 3.5))
    }
})
