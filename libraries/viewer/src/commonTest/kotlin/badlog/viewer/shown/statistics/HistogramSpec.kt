package badlog.viewer.shown.statistics

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.analysis.statistics
import badlog.core.recording.Topic
import badlog.viewer.bagView
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.pen.SvgPen
import badlog.viewer.draw.plot.HISTOGRAM_HEIGHT
import badlog.viewer.draw.plot.drawHistogram
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class HistogramSpec : FunSpec({
    fun histogramOf(view: LogView, topic: Topic, parts: List<Span>): Histogram? {
        val line = view.seriesOf(topic)
        return Histogram.of(line, parts, line.statistics(parts))
    }

    fun histogramOf(samples: List<Pair<Double, Double>>, vararg parts: Span, others: List<Pair<Double, Double>> = emptyList()): Histogram? {
        val topics = listOf(timedTopic("A", *samples.toTypedArray()), timedTopic("B", *others.toTypedArray()))
        val view = timedView(*topics.toTypedArray())
        return histogramOf(view, topics[0], parts.toList())
    }

    val changes = listOf(0.0 to 1.0, 6.0 to 4.0, 8.0 to Double.NaN, 9.0 to 2.5)

    test("a value counts as long as it holds, however often it is logged, and gaps do not count") {
        val histogram = histogramOf(changes, Span(0.0, 10.0), others = listOf(10.0 to 0.0))!!
        histogram.values shouldBe Span(1.0, 4.0)
        histogram.shares.withIndex().filter { it.value > 0 }.map { it.index } shouldBe listOf(0, 15, 29)
        histogram.shares.toList().filter { it > 0 }.zip(listOf(6.0, 1.0, 2.0)).forEach { (share, time) -> share shouldBe (time / 9 plusOrMinus 1e-12) }
        val repeated = (0 until 600).map { it / 100.0 to 1.0 } + changes.drop(1)
        histogramOf(repeated, Span(0.0, 10.0), others = listOf(10.0 to 0.0))!!.shares[0] shouldBe (6.0 / 9 plusOrMinus 1e-9)
    }

    test("only the parts count, and values that still hold from before them") {
        val histogram = histogramOf(changes, Span(5.0, 7.0))!!
        histogram.shares[0] shouldBe (0.5 plusOrMinus 1e-12)
        histogram.shares[29] shouldBe (0.5 plusOrMinus 1e-12)
        histogramOf(changes, Span(1.0, 2.0), Span(6.0, 7.0))!!.shares[0] shouldBe (0.5 plusOrMinus 1e-12)
    }

    test("a single value, no values, and states have no histogram") {
        histogramOf(listOf(0.0 to 3.0, 1.0 to 3.0), Span(0.0, 1.0)).shouldBeNull()
        histogramOf(changes, Span(20.0, 30.0)).shouldBeNull()
        val view = bagView(listOf("Time|xaxis", "Mode"), listOf("0,auto", "1,teleop"))
        histogramOf(view, view.recording.topics[1], listOf(Span(0.0, 1.0))).shouldBeNull()
    }

    test("the shares of any numbers add up to 1, and none is negative") {
        val number = Arb.element(0.0, -1.0, 1.0, 1e300, -1e300, Double.NaN, Double.POSITIVE_INFINITY, 1e-300)
        checkAll(Arb.list(number, 0..20)) { values ->
            val histogram = histogramOf(values.mapIndexed { i, value -> i.toDouble() to value }, Span(-1.0, 25.0)) ?: return@checkAll
            histogram.shares.sum() shouldBe (1.0 plusOrMinus 1e-9)
            histogram.shares.all { it >= 0 } shouldBe true
        }
    }

    test("each bin is a bar, with the values below and the share of the highest one above") {
        val pen = SvgPen({ text, letters, _ -> text.length * letters / 2 })
        pen.drawHistogram(histogramOf(changes, Span(0.0, 9.0))!!, "V", color = 0, width = 324.0, PenColors.LIGHT)
        val drawn = pen.document(324.0, HISTOGRAM_HEIGHT.toDouble(), PenColors.LIGHT[Shade.SURFACE]).split("<").map { it.trim() }
        drawn.filter { it.startsWith("path d=\"M12 16.5") } shouldBe listOf("""path d="M12 16.5h9v81.5h-9z" fill="#0b62c4"/>""")
        drawn.filter { it.startsWith("text") }.map { it.substringAfter('>') } shouldBe
            listOf("highest bar: 75.0 % of the time", "1", "2", "3", "4 V")
    }

    test("a value that hardly lasts still has a bar, a pixel high") {
        val pen = SvgPen({ text, letters, _ -> text.length * letters / 2 })
        val seldom = listOf(0.0 to 1.0, 5.0 to 4.0, 5.001 to 1.0)
        pen.drawHistogram(histogramOf(seldom, Span(0.0, 1000.0), others = listOf(1000.0 to 0.0))!!, "V", 0, width = 324.0, PenColors.LIGHT)
        pen.document(324.0, HISTOGRAM_HEIGHT.toDouble(), PenColors.LIGHT[Shade.SURFACE]) shouldContain """<path d="M302 97h9v1h-9z" fill="#0b62c4"/>"""
    }
})
