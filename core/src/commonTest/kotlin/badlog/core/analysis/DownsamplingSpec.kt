package badlog.core.analysis

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.random.Random

/** The result that [Downsampling] promises, computed in a slow and simple way. */
private fun expected(series: Series, from: Double, to: Double, count: Int): List<List<Double>> = List(count) { column ->
    val indices = series.x.indices.filter { i ->
        series.x[i] in from..to && columnOf(series.x[i], from, to, count) == column
    }
    val values = indices.map { i -> series.y[i].let { if (it.isFinite()) it else Double.NaN } }
    val finite = values.filter { it.isFinite() }
    listOf(
        values.firstOrNull() ?: Double.NaN,
        finite.minOrNull() ?: Double.NaN,
        finite.maxOrNull() ?: Double.NaN,
        values.lastOrNull() ?: Double.NaN,
        indices.size.toDouble(),
    )
}

private fun columnOf(x: Double, from: Double, to: Double, count: Int): Int = (0 until count - 1).firstOrNull { x < from + (to - from) * (it + 1) / count } ?: (count - 1)

private fun found(series: Series, from: Double, to: Double, count: Int): List<List<Double>> {
    val columns = PixelColumns(count)
    // Filled twice, because an earlier zoom must leave nothing behind.
    val downsampling = Downsampling(series)
    series.range?.let { if (it.endInclusive > it.start) downsampling.fill(it.start, it.endInclusive, columns) }
    downsampling.fill(from, to, columns)
    return List(count) {
        listOf(columns.first[it], columns.min[it], columns.max[it], columns.last[it], columns.samples[it].toDouble())
    }
}

class DownsamplingSpec : FunSpec({
    test("each pixel column has the first, least, greatest and last value of its samples") {
        val random = Random(7)
        repeat(60) {
            val size = random.nextInt(1, 3000)
            var time = 0.0
            val x = DoubleArray(size) { time.also { if (random.nextInt(4) > 0) time += random.nextDouble() } }
            val y = DoubleArray(size) {
                when (random.nextInt(20)) {
                    0 -> Double.NaN
                    1 -> Double.NEGATIVE_INFINITY
                    else -> random.nextDouble(-5.0, 5.0)
                }
            }
            val series = Series(x, y)
            val from = random.nextDouble(-1.0, time + 1)
            val to = from + random.nextDouble(0.01, time + 2)
            val count = random.nextInt(1, 40)
            // As text, because a gap does not equal a gap.
            found(series, from, to, count).toString() shouldBe expected(series, from, to, count).toString()
        }
    }

    test("a lone spike among a million samples shows at every zoom") {
        val size = 1_000_000
        val series = Series(DoubleArray(size) { it.toDouble() }, DoubleArray(size) { if (it == 765_432) 99.0 else 1.0 })
        val downsampling = Downsampling(series)
        for (width in listOf(1, 3, 800, 1600)) {
            for ((from, to) in listOf(0.0 to 999_999.0, 700_000.0 to 800_000.0, 765_432.0 to 765_433.0)) {
                val columns = PixelColumns(width)
                downsampling.fill(from, to, columns)
                columns.max.maxOf { if (it.isNaN()) 0.0 else it } shouldBe 99.0
                columns.samples.sum() shouldBe (to - from).toInt() + 1
            }
        }
    }

    test("a gap as wide as a column stays a gap, and differs from a column without samples") {
        val series = Series(DoubleArray(100) { it.toDouble() }, DoubleArray(100) { if (it in 40..59) Double.NaN else 1.0 })
        val columns = PixelColumns(10)
        Downsampling(series).fill(0.0, 100.0, columns)
        columns.min.map { it.isNaN() } shouldBe List(10) { it in 4..5 }
        columns.beginsInGap(4) shouldBe true
        columns.endsInGap(3) shouldBe false
        columns.samples[4] shouldBe 10
    }

    test("samples fall into the right columns even if x goes backwards") {
        val series = Series(doubleArrayOf(0.0, 1.0, 2.0, 0.5, 1.5), doubleArrayOf(1.0, 2.0, 3.0, -1.0, 9.0))
        val columns = PixelColumns(2)
        Downsampling(series).fill(0.0, 2.0, columns)
        columns.min.toList() shouldBe listOf(-1.0, 2.0)
        columns.max.toList() shouldBe listOf(1.0, 9.0)
        columns.last.toList() shouldBe listOf(-1.0, 9.0)
    }
})
