package badlog.viewer.draw.axis

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe

class YLimitsSpec : FunSpec({
    test("values that are never below 0 have no margin below 0") {
        limitsFor(0.1, 10.0, includesZero = false).from shouldBe 0.0
    }

    test("a line that is always 0 is not on the frame's edge") {
        val limits = limitsFor(0.0, 0.0, includesZero = true)
        limits.from shouldBeLessThan 0.0
        0.0 shouldBeLessThan limits.to
    }

    test("0 is included if required") {
        val above = limitsFor(11.0, 12.0, includesZero = true)
        above.from shouldBe 0.0
        12.0 shouldBeLessThan above.to
        limitsFor(-12.0, -11.0, includesZero = true).to shouldBe 0.0
    }

    test("a constant, no values, and the largest numbers have limits that can be drawn") {
        val nothing = Double.NaN to Double.NaN
        for ((least, most) in listOf(5.0 to 5.0, 0.0 to 0.0, -3.0 to -3.0, nothing, -1.7e308 to 1.7e308)) {
            val limits = limitsFor(least, most, includesZero = false)
            limits.from shouldBeLessThan limits.to
            limits.width.isFinite() shouldBe true
        }
    }
})
