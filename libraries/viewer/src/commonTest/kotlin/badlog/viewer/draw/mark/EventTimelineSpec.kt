package badlog.viewer.draw.mark

import badlog.core.analysis.Span
import badlog.core.analysis.stableOrder
import badlog.viewer.bagView
import badlog.viewer.shown.search.Query
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeSorted
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.checkAll
import kotlin.math.floor

class EventTimelineSpec : FunSpec({
    fun timelineOf(topics: List<String>, rows: List<String>) = EventTimeline.of(bagView(listOf("Time|xaxis") + topics, rows).folders.flatMap { it.eventLogs })

    fun timeline(events: List<Pair<Double, String>>) = timelineOf(listOf("Log|log"), events.map { (x, text) -> "$x,$text" })

    fun EventTimeline.texts() = (0 until size).map { "${x[it].takeUnless(Double::isNaN)?.toInt()} ${textOf(it)}" }

    val events = timelineOf(
        listOf("Arm/Log|log", "Drive/Log|log"),
        listOf("2,homed,", "1,,stopped", "3,jammed,Started", ",lost,", "5,,"),
    )

    test("events of all topics are in the order of x, and the ones without x last") {
        events.texts() shouldContainExactly listOf("1 stopped", "2 homed", "3 jammed", "3 Started", "null lost")
        events.placedCount shouldBe 4
    }

    test("a search finds words in text and topic, and is limited to its topics") {
        fun found(text: String, vararg topics: String) = events.matching(Query(text), topics.toSet()).texts()
        found("START") shouldContainExactly listOf("3 Started")
        found("arm jam") shouldContainExactly listOf("3 jammed")
        found("", "Drive/Log") shouldContainExactly listOf("1 stopped", "3 Started")
        found("nowhere") shouldBe emptyList()
        events.matching(Query(" ")) shouldBe events
    }

    test("the nearest event, and the last one, are found among those with an x") {
        events.nearest(2.4) shouldBe 1
        events.nearest(99.0) shouldBe 3
        events.nearest(99.0, 1.0) shouldBe null
        events.nearest(1.4, 1.0)?.text shouldBe "stopped"
        events.lastBefore(3.0)?.text shouldBe "Started"
        events.lastBefore(0.9) shouldBe null
        EventTimeline.NONE.nearest(1.0) shouldBe -1
    }

    test("sorting keeps the order of events at the same place") {
        checkAll(Arb.list(Arb.double(), 0..40)) { places ->
            stableOrder(places.toDoubleArray()).toList() shouldBe places.indices.sortedBy { places[it] }
        }
    }

    test("100,000 events are complete and found, with at most one mark for each pixel") {
        val many = timeline(List(100_000) { ((it * 7919L) % 100_000).toDouble() to "event ${it % 1000}" })
        many.x.toList().shouldBeSorted()
        many.matching(Query("event 77")).size shouldBe 1900
        val marks = EventMarks()
        marks.place(many, Span(0.0, 99_999.0), 50.0, 1.0)
        marks.size shouldBeLessThanOrEqual 51
    }

    test("each visible event has a mark at its pixel, each mark has an event, and a serious one is visible in any crowd") {
        checkAll(Arb.list(Arb.numericDouble(0.0, 10.0), 1..60), Arb.int(1..40)) { places, width ->
            val serious = places.indices.filter { it % 7 == 3 }
            val all = timeline(places.mapIndexed { i, x -> x to if (i in serious) "[WARN] $i" else "ok $i" })
            val marks = EventMarks()
            val span = Span(2.0, 8.0)
            marks.place(all, span, width.toDouble(), 1.0)
            val pixels = List(marks.size) { marks.pixelOf(it) }

            // The parser has rounded the places while reading the text.
            fun pixelsOf(indices: List<Int>) = indices.map { all.x[it] }.filter { it in span }.map { floor((it - 2.0) / 6.0 * width) }.distinct()
            pixels shouldBe pixelsOf((0 until all.size).toList())
            val seriousPixels = pixelsOf((0 until all.size).filter { "WARN" in all.textOf(it) })
            List(marks.size) { it }.filter { marks.isSerious(it) }.map { pixels[it] } shouldBe seriousPixels
            for (i in 0 until marks.size) if (marks.isSerious(i)) marks.hasHead(i) shouldBe true
            val lines = List(marks.size) { it }.filter { marks.hasLine(it) }.map { pixels[it] }
            lines.zipWithNext().all { (one, other) -> other - one >= 9 } shouldBe true
        }
    }

    test("a text that begins with error or warning is serious, after any signs") {
        fun isSerious(text: String) = timeline(listOf(1.0 to text)).areSerious(0, 1)
        listOf("ERROR: brownout", "[warning] low", "  Fatal", "severe", "(critical) x").map(::isSerious) shouldBe List(5) { true }
        listOf("no error", "_error", "erro", "12 warnings").map(::isSerious) shouldBe List(4) { false }
    }
})
