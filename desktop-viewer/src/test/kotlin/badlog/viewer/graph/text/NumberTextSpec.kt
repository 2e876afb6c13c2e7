package badlog.viewer.graph.text

import badlog.analysis.EnabledSpan
import badlog.plot.Span
import badlog.viewer.graph.bagOf
import badlog.viewer.graph.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class NumberTextSpec : FunSpec({
    test("samples read as on the exported page") {
        numberText(12.0) shouldBe "12"
        numberText(-0.0) shouldBe "0"
        numberText(6.7300000001) shouldBe "6.73"
        numberText(1.0 / 3) shouldBe "0.3333333"
        numberText(123456789.5) shouldBe "1.234568e+8"
        numberText(1.5e-7) shouldBe "1.5e-7"
        numberText(1.5e300) shouldBe "1.5e+300"
        numberText(Double.NaN) shouldBe "–"
        numberText(Double.NEGATIVE_INFINITY) shouldBe "-∞"
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
    }

    test("the cursor tells its place and how long the robot was enabled then") {
        val axis = recordingOf(bagOf(3) { 0.0 }).view.xAxis
        cursorText(93.7, axis, 160.0, listOf(EnabledSpan(Span(2.0, 150.0), false))) shouldBe "93.70 s · 1:31.7 since enabled"
        cursorText(93.7, axis, 160.0, emptyList()) shouldBe "93.70 s · 1:33.7"
        cursorText(9.0, axis, 160.0, emptyList()) shouldBe "9.00 s"
    }
})
