package badlog.viewer.shown.statistics

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class StatisticSpec : FunSpec({
    test("any count is complete, other numbers have a few digits, and a missing one is a dash") {
        Statistic.SAMPLES.textOf(12_345_678.0) shouldBe "12 345 678"
        Statistic.MAX.textOf(11.599600000000002) shouldBe "11.5996"
        for (statistic in listOf(Statistic.GAPS, Statistic.MEAN)) statistic.textOf(Double.NaN) shouldBe "–"
    }
})
