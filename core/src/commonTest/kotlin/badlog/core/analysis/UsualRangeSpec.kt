package badlog.core.analysis

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeNaN
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class UsualRangeSpec : FunSpec({
    val match = DoubleArray(5000) { it * 0.02 }
    fun with(vararg wild: Pair<Int, Double>) = UsualRange(match.copyOf().also { for ((row, x) in wild) it[row] = x })

    test("a wild position in any place and direction is ignored and reported") {
        for (row in listOf(0, 1, 777, 4999)) {
            for (x in listOf(18_446_744_073_692.0, -1e300, 1.7e9)) {
                val range = with(row to x)
                range.range shouldBe UsualRange(match.filterIndexed { i, _ -> i != row }.toDoubleArray()).range
                range.wildCount shouldBe 1
                range.wildest shouldBe x
            }
        }
        with(5 to 1e9, 6 to -1e12, 7 to 1e10).run { wildCount to wildest } shouldBe (3 to -1e12)
    }

    test("pauses, small clock changes and gaps are not wild positions") {
        UsualRange(DoubleArray(5000) { if (it < 4990) it * 0.02 else it * 0.02 + 3600 }).run { range to wildCount } shouldBe (0.0..3699.98 to 0)
        with(9 to -50.0).run { range?.start to wildCount } shouldBe (-50.0 to 0)
        with(0 to Double.NaN, 9 to Double.POSITIVE_INFINITY).run { range to wildCount } shouldBe (0.02..99.98 to 0)
    }

    test("many far positions, or any in a short log, are not wild") {
        UsualRange(DoubleArray(5000) { if (it % 50 == 0) 1e9 else it * 0.02 }).wildCount shouldBe 0
        UsualRange(doubleArrayOf(0.0, 1.0, 1e9)).run { range to wildCount } shouldBe (0.0..1e9 to 0)
        UsualRange(DoubleArray(0)).range shouldBe null
        UsualRange(DoubleArray(500) { 7.0 }).range shouldBe 7.0..7.0
        UsualRange(match).wildest.shouldBeNaN()
    }

    test("the range begins and ends at a position, and excludes at most one in a hundred") {
        checkAll(Arb.list(Arb.double(), 0..300), Arb.int(0..300)) { some, usual ->
            val positions = (some.take(some.size / 50) + List(usual) { it / 10.0 }).toDoubleArray()
            val result = UsualRange(positions)
            val range = result.range
            (range == null) shouldBe positions.none { it.isFinite() }
            if (range != null) (range.start in positions.toList() && range.endInclusive in positions.toList()) shouldBe true
            (result.wildCount <= positions.size / 100) shouldBe true
        }
    }
})
