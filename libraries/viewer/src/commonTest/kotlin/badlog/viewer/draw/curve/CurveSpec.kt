package badlog.viewer.draw.curve

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Series
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class CurveSpec : FunSpec({
    fun ramp(count: Int, y: (Int) -> Double = { it.toDouble() }) = Series(DoubleArray(count) { it.toDouble() }, DoubleArray(count) { y(it) })

    fun Curve.points() = List(size) { x[it] to y[it] }

    test("few samples are drawn as they are, with one more on either side") {
        val curve = Curve(ramp(100))
        curve.draw(10.0, 12.0, PixelColumns(100))
        curve.points() shouldBe listOf(9.0 to 9.0, 10.0 to 10.0, 11.0 to 11.0, 12.0 to 12.0, 13.0 to 13.0)
        curve.isSparse shouldBe true
        curve.isDense shouldBe false
    }

    test("invisible samples do not stretch the y axis") {
        val curve = Curve(ramp(100) { if (it == 13) 1e6 else 1.0 })
        curve.draw(10.0, 12.0, PixelColumns(100))
        curve.max shouldBe 1.0
    }

    test("the line between two samples is still drawn, and ends a little beyond the visible range") {
        val curve = Curve(Series(doubleArrayOf(0.0, 1000.0), doubleArrayOf(0.0, 1000.0)))
        curve.draw(500.0, 501.0, PixelColumns(100))
        curve.points() shouldBe listOf(499.0 to 499.0, 502.0 to 502.0)
        curve.max shouldBe 502.0
        curve.draw(0.0, 1.0, PixelColumns(100))
        curve.points() shouldBe listOf(0.0 to 0.0, 2.0 to 2.0)
    }

    test("a lone spike among many samples is drawn") {
        val curve = Curve(ramp(100_000) { if (it == 54_321) 7.0 else 0.0 })
        curve.draw(0.0, 99_999.0, PixelColumns(500))
        curve.isDense shouldBe true
        curve.max shouldBe 7.0
        (curve.size < 500 * 4) shouldBe true
        (0 until curve.size).count { curve.y[it] == 7.0 } shouldBe 1
    }

    test("gaps and infinities break the line") {
        val curve = Curve(
            ramp(5) {
                if (it == 2) {
                    Double.NaN
                } else if (it == 3) {
                    Double.POSITIVE_INFINITY
                } else {
                    1.0
                }
            },
        )
        curve.draw(0.0, 4.0, PixelColumns(10))
        (0 until curve.size).map { curve.y[it].isNaN() } shouldBe listOf(false, false, true, true, false)
    }

    test("x that goes backwards is drawn too") {
        val curve = Curve(Series(doubleArrayOf(0.0, 1.0, 2.0, 1.5), doubleArrayOf(1.0, 2.0, 3.0, 9.0)))
        curve.draw(0.0, 2.0, PixelColumns(4))
        curve.max shouldBe 9.0
    }

    test("a held value is a step, and the last one continues until the end") {
        val series = Series(doubleArrayOf(1.0, 3.0, 4.0), doubleArrayOf(5.0, 7.0, Double.NaN))
        val curve = Curve(series, holdsUntil = 9.0)
        curve.draw(0.0, 10.0, PixelColumns(100))
        curve.points().map { (x, y) -> x to y.takeUnless(Double::isNaN) } shouldBe
            listOf(1.0 to 5.0, 3.0 to 5.0, 3.0 to 7.0, 4.0 to 7.0, 4.0 to null)
        List(curve.size) { curve.isCorner(it) } shouldBe listOf(false, true, false, true, false)
        val open = Curve(Series(doubleArrayOf(1.0, 3.0), doubleArrayOf(5.0, 7.0)), holdsUntil = 9.0)
        open.draw(0.0, 10.0, PixelColumns(100))
        open.points().last() shouldBe (9.0 to 7.0)
        open.draw(1.5, 2.0, PixelColumns(100))
        open.points() shouldBe listOf(1.0 to 5.0, 2.5 to 5.0)
        open.min to open.max shouldBe (5.0 to 5.0)
        open.draw(4.0, 5.0, PixelColumns(100))
        open.points() shouldBe listOf(3.0 to 7.0, 6.0 to 7.0)
        open.draw(2.5, 4.0, PixelColumns(100))
        open.min to open.max shouldBe (5.0 to 7.0)
    }

    test("many held samples stay level over a stretch without any") {
        val x = DoubleArray(20_000) { if (it < 10_000) it * 1e-3 else 90 + it * 1e-3 }
        val curve = Curve(Series(x, DoubleArray(20_000) { if (it < 10_000) 0.0 else 1.0 }), holdsUntil = 110.0)
        curve.draw(0.0, 110.0, PixelColumns(110))
        for (i in 1 until curve.size) if (curve.y[i] != curve.y[i - 1]) curve.x[i] shouldBe curve.x[i - 1]
        curve.x[curve.size - 1] shouldBe 110.0
    }
})
