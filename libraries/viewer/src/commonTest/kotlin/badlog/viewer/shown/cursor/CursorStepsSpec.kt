package badlog.viewer.shown.cursor

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class CursorStepsSpec : FunSpec({
    test("steps go from sample to sample, over rows that share a time and over gaps") {
        val steps = CursorSteps(listOf(doubleArrayOf(0.0, 1.0, 1.0, Double.NaN, 2.0, 3.0)))
        steps.nearest(0.9) shouldBe 1.0
        steps.from(1.0, 1) shouldBe 2.0
        steps.from(2.0, -1) shouldBe 1.0
        steps.from(1.0, 10) shouldBe 3.0
        steps.from(1.5, -1) shouldBe 1.0
    }

    test("steps visit the samples of all clocks, in any order") {
        checkAll(Arb.list(Arb.list(Arb.int(-20..20), 0..8), 0..4), Arb.int(-25..25)) { clocks, start ->
            val steps = CursorSteps(clocks.map { clock -> DoubleArray(clock.size) { clock[it].toDouble() } })
            val all = clocks.flatten().distinct().sorted()
            if (all.isEmpty()) {
                steps.from(start.toDouble(), 1).isNaN() shouldBe true
                return@checkAll
            }
            val after = all.filter { it > start }.ifEmpty { listOf(all.last()) }
            val before = all.filter { it < start }.ifEmpty { listOf(all.first()) }
            steps.from(start.toDouble(), 1) shouldBe after.first().toDouble()
            steps.from(start.toDouble(), -1) shouldBe before.last().toDouble()
            steps.from(start.toDouble(), 3) shouldBe after.take(3).last().toDouble()
        }
    }
})
