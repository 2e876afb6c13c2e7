package badlog.signals.match

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import kotlin.math.sign

class NaturalOrderSpec : FunSpec({
    test("comparisons are consistent with each other") {
        val texts = Arb.string(0..6)
        checkAll(texts, texts, texts) { a, b, c ->
            NaturalOrder.compare(a, b).sign shouldBe -NaturalOrder.compare(b, a).sign
            val (first, second, third) = listOf(a, b, c).sortedWith(NaturalOrder)
            (NaturalOrder.compare(first, second) <= 0 && NaturalOrder.compare(first, third) <= 0) shouldBe true
        }
    }

    test("numbers are ordered by their value, letters regardless of case") {
        listOf("m10", "M9", "m09", "m", "").sortedWith(NaturalOrder) shouldContainExactly listOf("", "m", "M9", "m09", "m10")
    }
})
