package badlog.analysis

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
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

    test("the number that sorting would bring there comes to any place, with the smaller ones before it") {
        val random = Random(1)
        for (size in listOf(1, 2, 3, 31, 32, 33, 100, 599, 602, 5000)) {
            for (different in listOf(1, 2, 5, 1_000_000)) {
                val numbers = DoubleArray(size) { random.nextInt(different).toDouble() }
                for (place in listOf(0, size / 20, size / 2, size - 1)) check(numbers, place)
            }
        }
    }

    test("outside the range nothing moves") {
        val random = Random(2)
        val numbers = DoubleArray(3000) { random.nextDouble() }
        check(numbers, 1400, 1000, 2000)
    }

    test("numbers in no plain order are found as well") {
        val numbers = DoubleArray(100_000) { if (it % 1000 < 500) it.toDouble() else -it.toDouble() * it % 7919 }
        for (place in listOf(0, 5000, 50_000, 99_999)) check(numbers, place)
    }
})
