package badlog.core.analysis

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeNaN
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.choose
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import kotlin.math.abs
import kotlin.math.sqrt
import kotlin.random.Random

/** The statistics in a slow and simple way: all pieces over which a value holds, in sorted order. */
private fun statisticsBySorting(series: Series, from: Double, to: Double, end: Double): SeriesStatistics {
    val inside = (0 until series.size).filter { series.x[it] in from..to }
    val before = (0 until series.size).lastOrNull { series.x[it] < from }
        ?.takeIf { series.isOrdered && from <= to && (inside.isEmpty() || series.x[inside[0]] != from) }
    val used = listOfNotNull(before) + inside
    fun until(i: Int) = when {
        i == series.size - 1 -> maxOf(series.x[i], if (end.isNaN()) series.x[i] else end)
        series.isOrdered || series.x[i + 1] in from..to -> series.x[i + 1]
        else -> series.x[i]
    }
    val pieces = used.filter { series.y[it].isFinite() }.map { series.y[it] to maxOf(0.0, minOf(until(it), to) - maxOf(series.x[it], from)) }
    val values = pieces.map { it.first }
    val weighty = pieces.filter { it.second > 0 }.ifEmpty { pieces.map { it.first to 1.0 } }.sortedBy { it.first }
    val total = weighty.sumOf { it.second }
    fun percentile(share: Double): Double {
        var sum = 0.0
        for ((value, weight) in weighty) {
            sum += weight
            if (sum < total * share - total * 1e-9) continue
            if (sum > total * share + total * 1e-9) return value
            // The others of the same value may still follow.
            val reached = weighty.filter { it.first <= value }.sumOf { it.second }
            val above = weighty.firstOrNull { it.first > value }?.first ?: value
            return if (reached > total * share + total * 1e-9) value else (value + above) / 2
        }
        return Double.NaN
    }
    val mean = weighty.sumOf { it.first * (it.second / total) }
    return SeriesStatistics(
        count = inside.count { series.y[it].isFinite() },
        gaps = inside.count { !series.y[it].isFinite() },
        min = values.minOrNull() ?: Double.NaN,
        max = values.maxOrNull() ?: Double.NaN,
        mean = if (values.isEmpty()) Double.NaN else mean,
        standardDeviation = if (values.isEmpty()) Double.NaN else sqrt(weighty.sumOf { (it.first - mean) * (it.first - mean) * (it.second / total) }),
        percentile5 = percentile(0.05),
        median = percentile(0.5),
        percentile95 = percentile(0.95),
        first = values.firstOrNull() ?: Double.NaN,
        last = values.lastOrNull() ?: Double.NaN,
        integral = if (values.isEmpty()) Double.NaN else pieces.sumOf { (value, width) -> value * width },
    )
}

private infix fun SeriesStatistics.shouldBeLike(other: SeriesStatistics) {
    // As text, because NaN does not equal NaN; zeros have no sign here.
    fun SeriesStatistics.rest() = listOf(count, gaps, min + 0.0, max + 0.0, percentile5 + 0.0, median + 0.0, percentile95 + 0.0, first, last)
    rest().toString() shouldBe other.rest().toString()
    val pairs = listOf(mean to other.mean, standardDeviation to other.standardDeviation, integral to other.integral)
    for ((own, others) in pairs) {
        if (others.isNaN()) own.shouldBeNaN() else own shouldBe (others plusOrMinus 1e-9 * maxOf(1.0, abs(others), abs(other.max), abs(other.min)))
    }
}

/** Usual and unusual values of logs: few different ones, gaps, infinities, both zeros, huge ones.  */
private val VALUES = Arb.choose(
    6 to Arb.double(-5.0, 5.0),
    3 to Arb.element(-1.0, -0.0, 0.0, 1.0, 2.0),
    1 to Arb.element(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e100, -1e100),
)

class SeriesStatisticsSpec : FunSpec({
    val series = Series(
        doubleArrayOf(0.0, 1.0, 2.0, 3.0, 4.0, 5.0),
        doubleArrayOf(2.0, 4.0, Double.NaN, 4.0, 5.0, 9.0),
    )

    test("all statistics equal those calculated by hand") {
        val statistics = series.statistics()
        statistics.count shouldBe 5
        statistics.gaps shouldBe 1
        statistics.min shouldBe 2.0
        statistics.max shouldBe 9.0
        // 2, 4, 4 and 5 hold for 1 each, 9 for no time.
        statistics.mean shouldBe (3.75 plusOrMinus 1e-12)
        // Squares of the distances: 3.0625 + 0.0625 + 0.0625 + 1.5625 = 4.75; divided by 4.
        statistics.standardDeviation shouldBe (1.0897247358851685 plusOrMinus 1e-12)
        statistics.percentile5 shouldBe 2.0
        statistics.median shouldBe 4.0
        statistics.percentile95 shouldBe 5.0
        statistics.first shouldBe 2.0
        statistics.last shouldBe 9.0
        statistics.integral shouldBe (15.0 plusOrMinus 1e-12)
    }

    test("the last value holds until the end of the recording") {
        val statistics = series.statistics(end = 7.0)
        statistics.integral shouldBe (33.0 plusOrMinus 1e-12)
        statistics.median shouldBe 4.5
    }

    test("a value that still holds counts in a range without samples") {
        val changes = Series(doubleArrayOf(0.0, 10.0), doubleArrayOf(3.0, 7.0))
        changes.statistics(2.0, 4.0, end = 20.0).run { listOf(count.toDouble(), min, max, mean, first, last, integral) } shouldBe
            listOf(0.0, 3.0, 3.0, 3.0, 3.0, 3.0, 6.0)
        changes.statistics(8.0, 12.0, end = 20.0).mean shouldBe 5.0
        changes.statistics(12.0, 30.0, end = 20.0).integral shouldBe 56.0
    }

    test("a signal has the same statistics whether it is logged repeatedly or only when it changes") {
        val random = Random(3)
        repeat(PropertyTesting.defaultIterationCount) {
            val y = DoubleArray(50) { if (random.nextInt(8) == 0) Double.NaN else random.nextInt(4).toDouble() }
            val x = DoubleArray(50) { it * 0.5 }
            val kept = y.indices.filter { it == 0 || y[it].compareTo(y[it - 1]) != 0 }
            val changes = Series(DoubleArray(kept.size) { x[kept[it]] }, DoubleArray(kept.size) { y[kept[it]] })
            val from = random.nextInt(20).toDouble()
            fun Series.asked() = statistics(from, from + 4, end = 24.5).copy(count = 0, gaps = 0)
            changes.asked() shouldBeLike Series(x, y).asked()
        }
    }

    test("only samples inside the range count, both ends included") {
        val statistics = series.statistics(1.0, 4.0)
        statistics.count shouldBe 3
        statistics.first shouldBe 4.0
        statistics.last shouldBe 5.0
        statistics.integral shouldBe 8.0
    }

    test("samples between which x left the range have no area") {
        val there = Series(doubleArrayOf(0.0, 1.0, 2.0, 10.0, 3.0, 4.0), DoubleArray(6) { 1.0 })
        there.statistics(0.0, 5.0).integral shouldBe 3.0
    }

    test("a range without values has no statistics, and does not throw") {
        for (statistics in listOf(series.statistics(2.5, 2.75), series.statistics(-2.0, -1.0), series.statistics(3.0, 1.0))) {
            statistics.count shouldBe 0
            statistics.min.shouldBeNaN()
            statistics.mean.shouldBeNaN()
            statistics.median.shouldBeNaN()
            statistics.integral.shouldBeNaN()
        }
    }

    test("one value has no deviation") {
        series.statistics(0.0, 0.0).standardDeviation shouldBe 0.0
        series.statistics(0.0, 0.0).median shouldBe 2.0
    }

    test("statistics of any series equal those found by sorting its pieces") {
        val positions = Arb.list(Arb.element(List(12) { it * 0.5 }), 0..80)
        val farEnds = listOf(-1e300, 1e300, Double.NEGATIVE_INFINITY, Double.NaN)
        val ends = Arb.element(List(14) { it * 0.5 - 0.25 } + 2.0 + farEnds)
        checkAll(positions, Arb.list(VALUES, 80..80), ends, ends) { x, y, from, to ->
            for (places in listOf(x, x.sorted())) {
                val series = Series(places.toDoubleArray(), y.take(x.size).toDoubleArray())
                series.statistics(from, to, end = 6.0) shouldBeLike statisticsBySorting(series, from, to, 6.0)
            }
        }
    }

    test("statistics of large series equal those found by sorting") {
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
            series.statistics(to = to) shouldBeLike statisticsBySorting(series, Double.NEGATIVE_INFINITY, to, Double.NaN)
        }
    }

    test("statistics of several parts ignore everything between them") {
        val series = Series(DoubleArray(10) { it.toDouble() }, DoubleArray(10) { if (it in 3..5) 100.0 else it.toDouble() })
        val together = series.statistics(listOf(Span(0.5, 2.0), Span(6.0, 8.0)))
        together.count shouldBe 5
        together.min shouldBe 0.0
        together.max shouldBe 8.0
        together.first shouldBe 0.0
        together.last shouldBe 8.0
        // 0 holds for 0.5, 1 for 1, 6 for 1 and 7 for 1.
        together.integral shouldBe (14.0 plusOrMinus 1e-9)
        together.mean shouldBe (14.0 / 3.5 plusOrMinus 1e-9)
    }
})
