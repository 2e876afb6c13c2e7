package badlog.viewer.text

import badlog.core.analysis.LogView
import badlog.core.analysis.XAxis
import badlog.core.bag.BagParser
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class TimeTextSpec : FunSpec({
    fun axisOf(topics: String, vararg lines: String): XAxis {
        val parser = BagParser()
        val bag = (listOf("""{"topics":[$topics],"values":[]}""") + lines).joinToString("\n", postfix = "\n")
        parser.accept(bag.encodeToByteArray())
        return LogView.of(parser.finish()).xAxis
    }

    val seconds = axisOf("""{"name":"Time","unit":"s","attrs":["xaxis"]}""", "Time", "0", "160")
    val rows = axisOf("""{"name":"Current","unit":"A","attrs":[]}""", "Current", "1", "2")

    test("seconds are written as minutes and hours") {
        minutesText(93.74) shouldBe "1:33.7"
        minutesText(59.99) shouldBe "1:00.0"
        minutesText(-61.0, 0) shouldBe "-1:01"
        minutesText(-0.01) shouldBe "0:00.0"
        minutesText(3725.0) shouldBe "1:02:05.0"
        minutesText(Double.NaN) shouldBe "–"
        minutesText(1e300) shouldBe "1e300"
    }

    test("the cursor shows its place and other clocks, or otherwise minutes") {
        cursorText(93.7, seconds, 160.0, "Teleop 1:31") shouldBe "93.70 s · Teleop 1:31"
        cursorText(93.7, seconds, 160.0, "") shouldBe "93.70 s · 1:33.7"
        cursorText(9.0, seconds, 160.0, "") shouldBe "9.00 s"
    }

    test("an index has no decimals between two rows, and its length counts rows") {
        placeText(1.4, rows, 1.0) shouldBe "1"
        placeText(Double.NaN, rows, 1.0) shouldBe "–"
        lengthText(1.0, rows) shouldBe "1 row"
    }

    test("a length has its unit, and also minutes from one minute on") {
        lengthText(12.5, seconds) shouldBe "12.5 s"
        lengthText(90.0, seconds) shouldBe "90 s · 1:30.0"
        differenceText(5.0, 3.5, seconds) shouldBe "Δ -1.5 s"
    }
})
