package badlog.page.text

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class NumberTextSpec : FunSpec({
    test("numbers are as short as they can be") {
        numberText(12.5) shouldBe "12.5"
        numberText(1234567.0) shouldBe "1234567"
        numberText(0.1 + 0.2) shouldBe "0.3"
        numberText(1.5e-9) shouldBe "1.5e-9"
        numberText(Double.NaN) shouldBe "–"
        numberText(Double.NEGATIVE_INFINITY) shouldBe "-∞"
    }

    test("decimals follow what is visible") {
        decimalsFor(150.0) shouldBe 2
        decimalsFor(0.01) shouldBe 6
        decimalsOf(0.25) shouldBe 2
        decimalsOf(2.5) shouldBe 1
        decimalsOf(25.0) shouldBe 0
        decimalsOf(0.01) shouldBe 2
        decimalsOf(20.0) shouldBe 0
    }
})
