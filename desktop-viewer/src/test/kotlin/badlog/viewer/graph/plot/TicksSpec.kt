package badlog.viewer.graph.plot

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import kotlin.math.abs

class TicksSpec : FunSpec({
    test("ticks are multiples of 1, 2 or 5") {
        Ticks.of(0.0, 10.0, 10).values.toList().shouldContainExactly((0..10).map { it.toDouble() })
        Ticks.of(-3.0, 9.0, 5).values.toList().shouldContainExactly(0.0, 5.0)
        Ticks.of(11.7, 12.4, 4).step shouldBe 0.2
    }

    test("any range has no more than are asked for and one, ascending and within it") {
        checkAll(Arb.double(-1e300, 1e300), Arb.double(0.0, 1e300), Arb.int(1..20)) { from, width, most ->
            val ticks = Ticks.of(from, from + width, most).values
            ticks.size shouldBeLessThanOrEqual most + 1
            for (i in 1 until ticks.size) (ticks[i] >= ticks[i - 1]) shouldBe true
            val slack = maxOf(abs(from), abs(from + width)) * 1e-9
            ticks.all { it >= from - slack && it <= from + width + slack } shouldBe true
        }
    }

    test("what is no range has none") {
        Ticks.of(1.0, 1.0, 5).values.size shouldBe 0
        Ticks.of(Double.NaN, 1.0, 5).values.size shouldBe 0
        Ticks.of(0.0, Double.POSITIVE_INFINITY, 5).values.size shouldBe 0
    }
})
