package badlog.core.analysis

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.merge
import io.kotest.property.checkAll

class StableOrderSpec : FunSpec({
    test("stableOrder sorts any keys stably, with NaN last") {
        checkAll(Arb.list(Arb.element(1.0, 2.0, 3.0, Double.NaN).merge(Arb.double()), 0..70)) { list ->
            val keys = list.toDoubleArray()
            stableOrder(keys).toList() shouldBe keys.indices.sortedBy { keys[it] }
        }
    }

    test("stableOrder orders some of the indices, and leaves the given array unchanged") {
        val indices = intArrayOf(3, 1, 0)
        stableOrder(doubleArrayOf(5.0, 4.0, 3.0, 4.0), indices).toList() shouldBe listOf(3, 1, 0)
        indices.toList() shouldBe listOf(3, 1, 0)
        stableOrder(doubleArrayOf(1.0, 4.0, 3.0, 2.0), indices).toList() shouldBe listOf(0, 3, 1)
    }
})
