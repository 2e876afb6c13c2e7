package badlog.viewer.text

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.filter
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll
import kotlin.math.abs

class NumberTextSpec : FunSpec({
    test("any written sample is read back the same") {
        checkAll(Arb.long()) { bits ->
            val value = Double.fromBits(bits)
            if (value.isFinite()) exactText(value).toDouble() shouldBe value + 0.0
        }
        checkAll(Arb.double(-1e6, 1e6).filter { it.isFinite() }) { value -> exactText(value).toDouble() shouldBe value + 0.0 }
    }

    test("a sample that was logged with few decimals is written as logged") {
        checkAll(Arb.int(-1_000_000_000..1_000_000_000), Arb.int(0..9)) { number, decimals ->
            val logged = "${number}e-$decimals".toDouble()
            exactText(logged).substringBefore('e').filter { it.isDigit() }.trim('0').length shouldBeLessThanOrEqual number.toString().length
        }
    }

    test("large and small numbers have an exponent, others do not") {
        exactText(12.0) shouldBe "12"
        exactText(-0.0) shouldBe "0"
        exactText(0.1) shouldBe "0.1"
        exactText(-0.00125) shouldBe "-0.00125"
        exactText(0.1 + 0.2) shouldBe "0.30000000000000004"
        exactText(123456.75) shouldBe "123456.75"
        exactText(1.2345e7) shouldBe "12345000"
        exactText(1e-9) shouldBe "1e-9"
        exactText(-1.5e300) shouldBe "-1.5e300"
        exactText(1e15) shouldBe "1e15"
        exactText(Double.NaN) shouldBe "–"
        exactText(Double.NEGATIVE_INFINITY) shouldBe "-∞"
    }

    test("displayed whole numbers are complete; others have six digits, and no zero in place of a digit before the point") {
        numberText(1 / 3.0) shouldBe "0.333333"
        numberText(0.1 + 0.2) shouldBe "0.3"
        numberText(11.599600000000002) shouldBe "11.5996"
        numberText(123456.75) shouldBe "123457"
        numberText(1234567.0) shouldBe "1234567"
        numberText(-1234567.89) shouldBe "-1234568"
        numberText(0.000123456789) shouldBe "0.000123457"
        numberText(1.23456789e-9) shouldBe "1.23457e-9"
        numberText(1.23456789e300) shouldBe "1.23457e300"
        numberText(-0.0) shouldBe "0"
        numberText(Double.NaN) shouldBe "–"
        numberText(Double.NEGATIVE_INFINITY) shouldBe "-∞"
        checkAll(Arb.double(-1e300, 1e300).filter { it.isFinite() && abs(it) > 1e-300 }) { value ->
            numberText(value).toDouble() / value shouldBe (1.0 plusOrMinus 6e-6)
        }
        checkAll(Arb.double(-1e14, 1e14).filter { it.isFinite() && abs(it) > 1e6 }) { value ->
            numberText(value).toDouble() shouldBe (value plusOrMinus 0.5)
        }
    }

    test("a number with a given number of decimals is the nearest one, and never minus zero") {
        fixedText(-0.001, 2) shouldBe "0.00"
        fixedText(2.5, 0) shouldBe "3"
        fixedText(-2.5, 0) shouldBe "-3"
        fixedText(1e20, 2) shouldBe "1e20"
        checkAll(Arb.double(-1e9, 1e9).filter { it.isFinite() }, Arb.int(0..6)) { value, decimals ->
            abs(fixedText(value, decimals).toDouble() - value) * "1e$decimals".toDouble() shouldBe (0.25 plusOrMinus 0.26)
        }
    }

    test("places on an axis have as many decimals as distinguish them on the screen") {
        decimalsFor(150.0) shouldBe 2
        decimalsFor(0.01) shouldBe 6
        decimalsFor(0.0) shouldBe 9
    }

    test("a number is followed by its unit, and a missing number has none") {
        withUnit("12", "V") shouldBe "12 V"
        withUnit("12", "ul") shouldBe "12"
        withUnit("–", "V") shouldBe "–"
        unitText("ul") shouldBe ""
    }
})
