package badlog.viewer.draw.axis

import badlog.core.analysis.Span
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.arbitrary.orNull
import io.kotest.property.checkAll

class GraphAxisSpec : FunSpec({
    test("the first unit is on the left, the second on the right, and a third has its own scale, which the legend reports") {
        val axes = graphAxes(listOf("V", "A", "V", "rpm", "ul", ""))
        axes.map { it.side } shouldContainExactly listOf(AxisSide.LEFT, AxisSide.RIGHT, AxisSide.NONE, AxisSide.NONE)
        axes.map { it.lines } shouldContainExactly listOf(listOf(0, 2), listOf(1), listOf(3), listOf(4, 5))
        axes.map { it.side.legendOf(it.unit) } shouldContainExactly listOf("V", "A, right", "rpm, own scale", "own scale")
    }

    test("a hidden line leaves its axis to another unit") {
        graphAxes(listOf(null, "A", "rpm")).map { it.unit to it.side } shouldContainExactly
            listOf("A" to AxisSide.LEFT, "rpm" to AxisSide.RIGHT)
        graphAxes(listOf(null, null)) shouldBe emptyList()
    }

    test("each drawn line has one axis") {
        checkAll(Arb.list(Arb.element("V", "A", "", "ul", "rpm").orNull(), 0..12)) { units ->
            graphAxes(units).flatMap { it.lines }.sorted() shouldBe units.indices.filter { units[it] != null }
        }
    }

    test("selected limits are shown, and an axis without any moves along with the left one") {
        val axes = graphAxes(listOf("V", "A", "rpm"))
        val wholes = listOf(Span(0.0, 10.0), Span(0.0, 100.0), Span(0.0, 1000.0))
        axisLimits(axes, wholes, null) shouldBe wholes
        axisLimits(axes, wholes, Span(5.0, 10.0)) shouldBe listOf(Span(5.0, 10.0), Span(50.0, 100.0), Span(500.0, 1000.0))
        axisLimits(axes, wholes, Span(5.0, 10.0), Span(1.0, 2.0)) shouldBe listOf(Span(5.0, 10.0), Span(1.0, 2.0), Span(500.0, 1000.0))
        axisLimits(axes, wholes, null, Span(1.0, 2.0)) shouldBe listOf(wholes[0], Span(1.0, 2.0), wholes[2])
    }

    test("with any values and limits, each axis shows a range from a lower to a higher number") {
        val number = Arb.double()
        checkAll(number, number, number, number) { least, width, from, to ->
            val seen = if (width.isNaN() || least.isNaN()) Double.NaN else maxOf(least, width)
            val wholes = listOf(limitsFor(minOf(least, width), seen, false), limitsFor(0.0, 1.0, true))
            for (shown in axisLimits(graphAxes(listOf("V", "A")), wholes, Span(from, to), Span(to, from))) {
                (shown.to > shown.from && (shown.to - shown.from).isFinite()) shouldBe true
            }
        }
    }

    test("graphs with shared limits show the range of all of them for each unit") {
        val seen = listOf(SeenOfUnit("V", 1.0, 2.0), SeenOfUnit("A", 5.0, 6.0), SeenOfUnit("V", 0.5, 1.5), SeenOfUnit("V", Double.NaN, Double.NaN))
        seenTogether(seen) shouldBe mapOf("V" to SeenOfUnit("V", 0.5, 2.0), "A" to SeenOfUnit("A", 5.0, 6.0))
        checkAll(Arb.list(Arb.numericDouble(-1e9, 1e9), 1..20)) { values ->
            seenTogether(values.map { SeenOfUnit("", it, it + 1) })[""] shouldBe SeenOfUnit("", values.min(), values.max() + 1)
        }
    }
})
