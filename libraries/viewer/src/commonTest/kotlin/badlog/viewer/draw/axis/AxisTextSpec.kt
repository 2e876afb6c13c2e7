package badlog.viewer.draw.axis

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe

class AxisTextSpec : FunSpec({
    fun texts(from: Double, step: Double, letters: Int, count: Int = 5) = axisTexts(DoubleArray(count) { from + it * step }, step, letters)

    test("quarters have two decimals, and fifths one") {
        texts(0.0, 0.25, 8).shouldContainExactly("0.00", "0.25", "0.50", "0.75", "1.00")
        texts(0.0, 0.2, 8).shouldContainExactly("0.0", "0.2", "0.4", "0.6", "0.8")
        texts(-5.0, 2.5, 8).shouldContainExactly("-5.0", "-2.5", "0.0", "2.5", "5.0")
        texts(0.0, 25.0, 8).shouldContainExactly("0", "25", "50", "75", "100")
    }

    test("large numbers are plain if they fit, otherwise as exact as their step") {
        texts(150_000_000.0, 2_000_000.0, 10, 2).shouldContainExactly("150000000", "152000000")
        texts(150_000_000.0, 2_000_000.0, 8, 2).shouldContainExactly("1.50e8", "1.52e8")
        texts(1_710_585_600.0, 100.0, 10, 2).shouldContainExactly("1710585600", "1710585700")
    }

    test("numbers that do not fit either way lose their beginning") {
        texts(1_710_585_600.0, 100.0, 8, 2).shouldContainExactly("…0585600", "…0585700")
    }

    test("small numbers are as exact as their step") {
        texts(0.0, 2.5e-7, 8, 4).shouldContainExactly("0", "2.5e-7", "5.0e-7", "7.5e-7")
    }

    test("neighboring ticks differ, and fit, at every magnitude") {
        for (decade in -12..300 step 3) {
            for (factor in listOf(1.0, 2.0, 2.5, 5.0)) {
                val step = factor * "1e$decade".toDouble()
                for (from in listOf(0.0, step * 40, step * 4_000, -step * 40)) {
                    val texts = texts(from, step, 8)
                    texts.shouldBeUnique()
                    texts.maxOf { it.length } shouldBeLessThanOrEqual 8
                }
            }
        }
    }

    test("the number of decimals follows from a step of one or two digits") {
        decimalsOf(0.25) shouldBe 2
        decimalsOf(2.5) shouldBe 1
        decimalsOf(25.0) shouldBe 0
        decimalsOf(0.01) shouldBe 2
        decimalsOf(20.0) shouldBe 0
    }
})
