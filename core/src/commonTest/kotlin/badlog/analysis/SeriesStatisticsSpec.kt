package badlog.analysis

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeNaN
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.choose
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import kotlin.math.sqrt
import kotlin.random.Random

/** The statistics the slow way: all samples, in sorted order. Sums are those of the series without the others. */
private fun sortedWay(series: Series, from: Double, to: Double): SeriesStatistics {
    val inside = (0 until series.size).filter { series.x[it] in from..to }
    val values = inside.map { series.y[it] }.filter { it.isFinite() }
    val sorted = values.sorted()
    fun percentile(share: Double): Double {
        if (sorted.isEmpty()) return Double.NaN
        val place = share * sorted.lastIndex
        val below = sorted[place.toInt()]
        val above = sorted[minOf(place.toInt() + 1, sorted.lastIndex)]
        return below + (above - below) * (place - place.toInt())
    }
    var mean = 0.0
    var squares = 0.0
    values.forEachIndexed { index, value ->
        val distance = value - mean
        mean += distance / (index + 1)
        squares += distance * (value - mean)
    }
    val area = TrapezoidSum()
    for (i in 0 until series.size) if (series.x[i] in from..to) area.add(series.x[i], series.y[i]) else area.interrupt()
    return SeriesStatistics(
        count = values.size,
        gaps = inside.size - values.size,
        min = sorted.firstOrNull() ?: Double.NaN,
        max = sorted.lastOrNull() ?: Double.NaN,
        mean = if (values.isEmpty()) Double.NaN else mean,
        standardDeviation = if (values.size > 1) sqrt(squares / (values.size - 1)) else Double.NaN,
        percentile5 = percentile(0.05),
        median = percentile(0.5),
        percentile95 = percentile(0.95),
        first = values.firstOrNull() ?: Double.NaN,
        last = values.lastOrNull() ?: Double.NaN,
        integral = if (values.isEmpty()) Double.NaN else area.value,
    )
}

/** Values as logs have them, and as they should not be: few different ones, gaps, infinities, both zeros, huge ones. */
private val VALUES = Arb.choose(
    6 to Arb.double(-5.0, 5.0),
    3 to Arb.element(-1.0, -0.0, 0.0, 1.0, 2.0),
    1 to Arb.element(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.MAX_VALUE, -Double.MAX_VALUE),
)

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

    test("samples that are neighbors only because x left the range between them have no area") {
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

    test("any series has the very figures that sorting all its samples gives, ordered or not") {
        val positions = Arb.list(Arb.element(List(12) { it * 0.5 }), 0..80)
        val farEnds = listOf(-1e300, 1e300, Double.NEGATIVE_INFINITY, Double.NaN)
        val ends = Arb.element(List(14) { it * 0.5 - 0.25 } + 2.0 + farEnds)
        checkAll(1000, positions, Arb.list(VALUES, 80..80), ends, ends) { x, y, from, to ->
            for (places in listOf(x, x.sorted())) {
                val series = Series(places.toDoubleArray(), y.take(x.size).toDoubleArray())
                // As text, because NaN does not equal NaN, and because zeros have signs.
                series.statistics(from, to).toString() shouldBe sortedWay(series, from, to).toString()
            }
        }
    }

    test("large series have the very figures too, whatever their shape") {
        val random = Random(42)
        val size = 20_000
        val shapes = listOf<(Int) -> Double>(
            { random.nextDouble() },
            { it.toDouble() },
            { -it.toDouble() },
            { 7.0 },
            { (it % 3).toDouble() },
            { minOf(it, size - it).toDouble() },
            { if (random.nextInt(50) == 0) random.nextDouble() * 1e9 else 0.0 },
            { (it xor 0x155).toDouble() },
            { if (it % 2 == 0) it.toDouble() else -it.toDouble() },
        )
        for (shape in shapes) {
            val series = Series(DoubleArray(size) { it * 0.02 }, DoubleArray(size, shape))
            val to = random.nextDouble() * 400
            series.statistics(to = to).toString() shouldBe sortedWay(series, Double.NEGATIVE_INFINITY, to).toString()
        }
    }
})
