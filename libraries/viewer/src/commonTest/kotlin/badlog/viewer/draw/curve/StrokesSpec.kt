package badlog.viewer.draw.curve

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class StrokesSpec : FunSpec({
    fun curveOf(y: List<Double>, columns: Int, holdsUntil: Double? = null): Curve {
        val series = Series(DoubleArray(y.size) { it.toDouble() }, y.toDoubleArray())
        return Curve(series, holdsUntil).apply { draw(0.0, maxOf(1.0, y.size - 1.0), PixelColumns(columns)) }
    }

    fun Strokes.strokes() = List(count) { i -> (startOf(i) until endOf(i) step 2).map { points[it] to points[it + 1] } }
    fun Strokes.dotList() = (0 until dotsSize step 2).map { dots[it] to dots[it + 1] }

    test("strokes are the whole points between gaps, in order, also when the arrays are reused") {
        val strokes = Strokes()
        checkAll(Arb.list(Arb.element(0.0, 1.0, 7.0, Double.NaN, Double.POSITIVE_INFINITY), 0..60), Arb.int(1..50)) { y, columns ->
            val curve = curveOf(y, columns)
            strokes.trace(curve, Scale.NONE, Scale.NONE)
            val expected = ArrayList<MutableList<Pair<Double, Double>>>()
            var isOpen = false
            for (i in 0 until curve.size) {
                val isGap = curve.y[i].isNaN()
                if (!isGap && !isOpen) expected += ArrayList<Pair<Double, Double>>()
                if (!isGap) expected.last() += curve.x[i] to curve.y[i]
                isOpen = !isGap
            }
            strokes.strokes() shouldBe expected
            if (!curve.isSparse) strokes.dotList() shouldBe expected.filter { it.size == 1 }.map { it[0] }
        }
    }

    test("each of few samples has a dot, but not the corners of a step") {
        val strokes = Strokes()
        strokes.trace(curveOf(listOf(1.0, 3.0), 100, holdsUntil = 1.0), Scale.NONE, Scale.NONE)
        strokes.isSparse shouldBe true
        strokes.dotList() shouldBe listOf(0.0 to 1.0, 1.0 to 3.0)
        strokes.strokes().single().size shouldBe 4
    }

    test("a scale applied later gives the same strokes as one known before") {
        val curve = curveOf(listOf(1.0, 3.0, Double.NaN, 1e300), 100)
        val x = Scale.ofX(Span(0.0, 3.0), 90.0, left = 10.0)
        val y = Scale.ofY(Span(0.0, 4.0), 40.0)
        val once = Strokes().apply { trace(curve, x, y) }
        val twice = Strokes().apply {
            trace(curve, x, Scale.NONE)
            place(y)
        }
        once.strokes() shouldBe twice.strokes()
        once.dotList() shouldBe twice.dotList()
        // A place far outside the screen is still near enough to be drawn.
        once.strokes() shouldBe listOf(listOf(10.0 to 30.0, 40.0 to 10.0), listOf(100.0 to -2000.0))
    }
})
