package badlog.viewer.text

import badlog.analysis.EnabledSpan
import badlog.analysis.Span
import badlog.viewer.graph.bagOf
import badlog.viewer.graph.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.checkAll

class NumberTextSpec : FunSpec({
    test("a sample is written so that it can be read back, whatever it is") {
        checkAll(Arb.double()) { value -> if (value.isFinite()) exactText(value).toDouble() shouldBe value + 0.0 }
        exactText(12.0) shouldBe "12"
        exactText(-0.0) shouldBe "0"
        exactText(1.2345e7) shouldBe "12345000"
        exactText(1e-9) shouldBe "1e-9"
        exactText(Double.NaN) shouldBe "–"
        exactText(Double.NEGATIVE_INFINITY) shouldBe "-∞"
    }

    test("a figure has six digits, and none that a calculation makes up") {
        figureText(1 / 3.0) shouldBe "0.333333"
        figureText(0.1 + 0.2) shouldBe "0.3"
    }

    test("a number has its unit behind it, and no number has none") {
        withUnit("12", "V") shouldBe "12 V"
        withUnit("12", "ul") shouldBe "12"
        withUnit("–", "V") shouldBe "–"
    }

    test("the numbers of an axis are as long as tells them apart, and no longer than there is room") {
        axisTexts(doubleArrayOf(0.0, 0.5, 1.0), 0.5, 8) shouldBe listOf("0.0", "0.5", "1.0")
        axisTexts(doubleArrayOf(0.0, 1e20), 1e20, 8) shouldBe listOf("0", "1e20")
        axisTexts(doubleArrayOf(1e-9, 2e-9), 1e-9, 8) shouldBe listOf("1e-9", "2e-9")
        axisTexts(doubleArrayOf(123456.7891, 123456.7892), 1e-4, 8).all { it.length == 8 } shouldBe true
    }

    test("minutes") {
        minutesText(93.74) shouldBe "1:33.7"
        minutesText(59.99) shouldBe "1:00.0"
        minutesText(-61.0, 0) shouldBe "-1:01"
        minutesText(3725.0) shouldBe "1:02:05.0"
    }

    test("the cursor tells its place and how long the robot was enabled then") {
        val axis = recordingOf(bagOf(3) { 0.0 }).view.xAxis
        cursorText(93.7, axis, 160.0, listOf(EnabledSpan(Span(2.0, 150.0), false))) shouldBe "93.70 s · 1:31.7 since enabled"
        cursorText(93.7, axis, 160.0, emptyList()) shouldBe "93.70 s · 1:33.7"
        cursorText(9.0, axis, 160.0, emptyList()) shouldBe "9.00 s"
    }
})
