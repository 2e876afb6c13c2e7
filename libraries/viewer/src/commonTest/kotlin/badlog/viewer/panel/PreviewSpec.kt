package badlog.viewer.panel

import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.statistics
import badlog.core.recording.TopicKind
import badlog.viewer.catalog.PreviewLine
import badlog.viewer.catalog.TopicSummary
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import kotlin.math.abs

class PreviewSpec : FunSpec({
    fun preview(vararg y: Double, range: Span): Preview {
        val series = Series(DoubleArray(y.size) { it.toDouble() }, y)
        val statistics = series.statistics()
        val shape = PreviewLine.of(series, statistics.min, statistics.max)
        return Preview(TopicSummary("Volts", "V", TopicKind.NUMERIC, statistics, shape), range)
    }

    val rising = DoubleArray(PreviewLine.COLUMNS) { it.toDouble() }

    test("a line goes from the left to the right, and the smallest value of the range is at the bottom") {
        val line = preview(*rising, range = Span(0.0, 94.0)).lines.single()
        line.size shouldBe 4 * PreviewLine.COLUMNS
        (line[0] to line[line.size - 2]) shouldBe (0.25 / PreviewLine.COLUMNS to (PreviewLine.COLUMNS - 0.25) / PreviewLine.COLUMNS)
        line[1] shouldBe (1.0 plusOrMinus 0.01)
        line.last() shouldBe (0.5 plusOrMinus 0.01)
    }

    test("a gap ends a line, and without values there are none") {
        val gap = rising.copyOf().also { it.fill(Double.NaN, 10, 20) }
        preview(*gap, range = Span(0.0, 47.0)).lines.map { it.size / 4 } shouldBe listOf(10, PreviewLine.COLUMNS - 20)
        preview(Double.NaN, range = Span(0.0, 1.0)).lines.shouldBeEmpty()
    }

    test("values outside the range stay at its edge, and a range of a single value is in the middle") {
        val line = preview(*rising, range = Span(10.0, 20.0)).lines.single()
        (line[1] to line.last()) shouldBe (1.0 to 0.0)
        preview(12.0, 12.0, range = Span(12.0, 12.0)).lines.first()[1] shouldBe 0.5
    }

    test("a column begins at the end that is nearer to the one before") {
        val zigzag = DoubleArray(10 * PreviewLine.COLUMNS) { if (it % 10 == 0) 0.0 else 1.0 }
        val line = preview(*zigzag, range = Span(0.0, 1.0)).lines.single()
        val jumps = (1 until PreviewLine.COLUMNS).map { abs(line[4 * it + 1] - line[4 * it - 1]) }
        jumps.max() shouldBeLessThan 0.1
    }
})
