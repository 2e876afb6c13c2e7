package badlog.viewer.catalog

import badlog.core.analysis.Series
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class PreviewLineSpec : FunSpec({
    fun ramp(size: Int) = DoubleArray(size) { it.toDouble() }

    test("a peak of one sample is visible") {
        val preview = PreviewLine.of(Series(ramp(4800), DoubleArray(4800) { if (it == 1234) 1.0 else 0.0 }), 0.0, 1.0)
        (0 until PreviewLine.COLUMNS).filter { preview.high(it) == 1f } shouldBe listOf(12)
        preview.low(12) shouldBe 0f
    }

    test("a gap in x has no values") {
        val preview = PreviewLine.of(Series(doubleArrayOf(0.0, 100.0), doubleArrayOf(5.0, 5.0)), 5.0, 5.0)
        (0 until PreviewLine.COLUMNS).filter { preview.has(it) } shouldBe listOf(0, 47)
    }

    test("a held value continues until the next one, and to the end") {
        val series = Series(doubleArrayOf(12.0, 24.0), doubleArrayOf(0.0, 1.0))
        val preview = PreviewLine.of(series, 0.0, 1.0, 0.0..48.0)
        (0 until PreviewLine.COLUMNS).map { if (preview.has(it)) preview.low(it) to preview.high(it) else null } shouldBe
            List(12) { null } + List(12) { 0f to 0f } + (0f to 1f) + List(23) { 1f to 1f }
    }

    test("any series has a preview") {
        checkAll(Arb.list(Arb.double(), 0..60), Arb.list(Arb.double(), 60..60)) { x, y ->
            val finite = x.filter { it.isFinite() }.toDoubleArray()
            val values = y.take(finite.size).toDoubleArray()
            val known = values.filter { it.isFinite() }
            PreviewLine.of(Series(finite, values), known.minOrNull() ?: Double.NaN, known.maxOrNull() ?: Double.NaN)
        }
    }
})
