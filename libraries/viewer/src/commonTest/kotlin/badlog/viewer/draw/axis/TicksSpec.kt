package badlog.viewer.draw.axis

import badlog.core.analysis.Span
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import kotlin.math.abs
import kotlin.math.pow

class TicksSpec : FunSpec({
    fun of(from: Double, to: Double, most: Int) = Ticks.of(Span(from, to), most, letters = 8)

    test("ticks are multiples of 1, 2 or 5") {
        of(0.0, 10.0, 10).values.toList().shouldContainExactly((0..10).map { it.toDouble() })
        of(-3.0, 9.0, 5).values.toList().shouldContainExactly(0.0, 5.0)
        of(11.7, 12.4, 4).step shouldBe 0.2
    }

    test("any range has at most one tick more than requested, ascending and within the range") {
        checkAll(Arb.double(-1e300, 1e300), Arb.double(0.0, 1e300), Arb.int(1..20)) { from, width, most ->
            val ticks = of(from, from + width, most).values
            ticks.size shouldBeLessThanOrEqual most + 1
            for (i in 1 until ticks.size) (ticks[i] >= ticks[i - 1]) shouldBe true
            val slack = maxOf(abs(from), abs(from + width)) * 1e-9
            ticks.all { it >= from - slack && it <= from + width + slack } shouldBe true
        }
    }

    test("each number beside an axis is exact, so that its text is as even as its place") {
        for ((least, most) in listOf(0.0 to 1.0, -3.0 to 7.0, 0.0 to 12.7, -1.0 to 1.0, 0.0 to 0.002, 99.0 to 99.5)) {
            for (height in listOf(120.0, 240.0)) {
                val ticks = Ticks.ofY(Span(least, most), height)
                ticks.texts.size shouldBeGreaterThan 2
                ticks.texts.forEachIndexed { index, text -> text.toDouble() shouldBe (ticks.values[index] plusOrMinus ticks.step * 1e-6) }
            }
        }
    }

    test("an empty or infinite range has no ticks") {
        of(1.0, 1.0, 5).values.size shouldBe 0
        of(Double.NaN, 1.0, 5).values.size shouldBe 0
        of(0.0, Double.POSITIVE_INFINITY, 5).values.size shouldBe 0
    }

    test("in any range, tick texts differ, are short enough, and are read back as their places") {
        checkAll(Arb.double(-1e9, 1e9), Arb.double(-12.0, 12.0), Arb.double(10.0, 2_000.0)) { from, decades, room ->
            // The narrowest visible range.
            val width = maxOf(10.0.pow(decades), abs(from) * 1e-11)
            for ((ticks, letters) in listOf(Ticks.ofX(Span(from, from + width), room) to 12, Ticks.ofY(Span(from, from + width), room) to 8)) {
                ticks.texts.shouldBeUnique()
                ticks.texts.forEachIndexed { index, text ->
                    text.length shouldBeLessThanOrEqual letters
                    if (text[0] != '…') text.toDouble() shouldBe (ticks.values[index] plusOrMinus ticks.step / 2)
                }
            }
        }
    }
})
