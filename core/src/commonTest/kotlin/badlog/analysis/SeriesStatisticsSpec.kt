package badlog.analysis

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeNaN
import io.kotest.matchers.shouldBe

class SeriesStatisticsSpec : FunSpec({
    val series = Series(
        doubleArrayOf(0.0, 1.0, 2.0, 3.0, 4.0, 5.0),
        doubleArrayOf(2.0, 4.0, Double.NaN, 4.0, 5.0, 9.0),
    )

    test("every figure is as worked out by hand") {
        val statistics = series.statistics()
        statistics.count shouldBe 5
        statistics.gaps shouldBe 1
        statistics.min shouldBe 2.0
        statistics.max shouldBe 9.0
        statistics.mean shouldBe (4.8 plusOrMinus 1e-12)
        // Squares of the distances: 7.84 + 0.64 + 0.64 + 0.04 + 17.64 = 26.8; divided by 4.
        statistics.standardDeviation shouldBe (2.588435821108957 plusOrMinus 1e-12)
        // Places 0.2, 2 and 3.8 among 2, 4, 4, 5, 9.
        statistics.percentile5 shouldBe (2.4 plusOrMinus 1e-12)
        statistics.median shouldBe 4.0
        statistics.percentile95 shouldBe (8.2 plusOrMinus 1e-12)
        statistics.first shouldBe 2.0
        statistics.last shouldBe 9.0
        // 3 before the gap, 4.5 + 7 after it.
        statistics.integral shouldBe (14.5 plusOrMinus 1e-12)
    }

    test("only samples inside the range count, both ends included") {
        val statistics = series.statistics(1.0, 4.0)
        statistics.count shouldBe 3
        statistics.first shouldBe 4.0
        statistics.last shouldBe 5.0
    }

    test("samples that are neighbours only because x left the range between them have no area") {
        val there = Series(doubleArrayOf(0.0, 1.0, 2.0, 10.0, 3.0, 4.0), DoubleArray(6) { 1.0 })
        there.statistics(0.0, 5.0).integral shouldBe 3.0
    }

    test("a range without values has no figures, and throws nothing") {
        for (statistics in listOf(series.statistics(1.5, 2.5), series.statistics(10.0, 20.0), series.statistics(3.0, 1.0))) {
            statistics.count shouldBe 0
            statistics.min.shouldBeNaN()
            statistics.mean.shouldBeNaN()
            statistics.median.shouldBeNaN()
            statistics.integral.shouldBeNaN()
        }
    }

    test("one value has no standard deviation") {
        series.statistics(0.0, 0.0).standardDeviation.shouldBeNaN()
        series.statistics(0.0, 0.0).median shouldBe 2.0
    }
})
