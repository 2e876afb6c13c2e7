package badlog.core.analysis

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.math.pow
import kotlin.random.Random

class SelectionSpec : FunSpec({
    fun check(numbers: DoubleArray, place: Int, from: Int = 0, until: Int = numbers.size) {
        val expected = numbers.copyOf().apply { sort(from, until) }
        val selected = numbers.copyOf()
        select(selected, place, from, until)
        selected[place] shouldBe expected[place]
        for (i in from until place) (selected[i] <= selected[place]) shouldBe true
        for (i in place + 1 until until) (selected[i] >= selected[place]) shouldBe true
        selected.apply { sort(from, until) } shouldBe expected
    }

    test("select puts the number that sorting would at any place, with smaller ones before it") {
        val random = Random(1)
        for (size in listOf(1, 2, 3, 31, 32, 33, 100, 599, 602, 5000)) {
            for (different in listOf(1, 2, 5, 1_000_000)) {
                val numbers = DoubleArray(size) { random.nextInt(different).toDouble() }
                for (place in listOf(0, size / 20, size / 2, size - 1)) check(numbers, place)
            }
        }
    }

    test("select moves nothing outside its range") {
        val random = Random(2)
        val numbers = DoubleArray(3000) { random.nextDouble() }
        check(numbers, 1400, 1000, 2000)
    }

    test("select works for numbers in irregular order") {
        val numbers = DoubleArray(100_000) { if (it % 1000 < 500) it.toDouble() else -it.toDouble() * it % 7919 }
        for (place in listOf(0, 5000, 50_000, 99_999)) check(numbers, place)
    }

    /** By definition, from all values in order. */
    fun percentile(values: DoubleArray, weights: DoubleArray, share: Double): Double {
        val ordered = values.indices.sortedBy { values[it] }
        val wanted = weights.sum() * share
        val rounding = weights.sum() * 1e-9
        var weight = 0.0
        ordered.forEachIndexed { place, i ->
            weight += weights[i]
            val isLastOfItsValue = place + 1 == ordered.size || values[ordered[place + 1]] > values[i]
            if (isLastOfItsValue && weight >= wanted - rounding) {
                val next = if (place + 1 < ordered.size) values[ordered[place + 1]] else values[i]
                return if (weight <= wanted + rounding && next.isFinite()) (values[i] + next) / 2 else values[i]
            }
        }
        error("The weights do not come to the share.")
    }

    test("percentiles follow their definition for any distribution of values") {
        val random = Random(3)
        val shapes = mapOf<String, (Int) -> Double>(
            "even" to { random.nextDouble() },
            "few different" to { random.nextInt(4).toDouble() },
            "all the same" to { 12.5 },
            "one far away" to { if (it == 7) 1e12 else random.nextDouble() },
            "over many powers of ten" to { 10.0.pow(random.nextInt(-300, 300)) },
            "beyond the largest range" to { if (it % 2 == 0) 1.7e308 else -1.7e308 * random.nextDouble() },
            "with the smallest range" to { if (it % 3 == 0) Double.MIN_VALUE else 0.0 },
            "infinite ones" to { if (it % 5 == 0) Double.POSITIVE_INFINITY else random.nextDouble() },
        )
        for ((name, shape) in shapes) {
            for (size in listOf(1, 2, 63, 64, 65, 1000, 7500)) {
                for (isEven in listOf(true, false)) {
                    val values = DoubleArray(size, shape)
                    val weights = DoubleArray(size) { if (isEven) 0.02 else random.nextDouble(0.001, 10.0) }
                    for (share in listOf(0.0, 0.05, 0.25, 0.5, 0.95, 1.0)) {
                        withClue("$name, $size, $isEven, $share") {
                            weightedPercentile(values, weights, size, share) shouldBe percentile(values, weights, share)
                        }
                    }
                }
            }
        }
    }

    test("only the first values count, and without any there is no percentile") {
        weightedPercentile(doubleArrayOf(1.0, 2.0, 99.0), doubleArrayOf(1.0, 3.0, 99.0), 2, 0.5) shouldBe 2.0
        weightedPercentile(doubleArrayOf(1.0), doubleArrayOf(1.0), 0, 0.5).isNaN() shouldBe true
    }
})
