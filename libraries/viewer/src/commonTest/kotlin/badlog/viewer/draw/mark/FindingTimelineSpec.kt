package badlog.viewer.draw.mark

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class FindingTimelineSpec : FunSpec({
    class Finding(val name: String, val severity: Severity, vararg val spans: Span)

    fun timelineOf(all: List<Finding>) = FindingTimeline(all, { it.severity }, { it.spans.toList() })

    val late = Finding("Late", Severity.NOTE, Span(81.0, 100.0))
    val whole = Finding("Whole", Severity.ERROR)
    val early = Finding("Early", Severity.ERROR, Span(21.0, 30.0), Span(60.0, 60.0))
    val middle = Finding("Middle", Severity.WARNING, Span(51.0, 100.0))
    val timeline = timelineOf(listOf(late, whole, early, middle))
    val all = Span(0.0, 100.0)

    val found = arbitrary {
        val from = Arb.int(-5..105).bind()
        Finding("", Arb.enum<Severity>().bind(), Span(from.toDouble(), from + Arb.int(0..20).bind().toDouble()))
    }

    test("the worst finding is first, and findings about the whole log before the ones with a place") {
        timeline.worstFirst.map { it.name } shouldContainExactly listOf("Whole", "Early", "Middle", "Late")
        timeline.places.map { it.finding.name } shouldContainExactly listOf("Early", "Middle", "Early", "Late")
        timeline.count(Severity.ERROR) shouldBe 2
    }

    test("steps within a finding begin at the cursor's place, or otherwise the first one, and stop at the ends") {
        fun step(steps: Int, x: Double) = timeline.within(early, x, steps)?.span?.from
        step(1, 21.0) shouldBe 60.0
        step(1, 60.0) shouldBe 60.0
        step(-1, 60.0) shouldBe 21.0
        step(-1, 21.0) shouldBe 21.0
        step(1, Double.NaN) shouldBe 60.0
        timeline.within(whole, 1.0, 1) shouldBe null
    }

    test("findings near a place are found, however many places are before it") {
        checkAll(Arb.list(found, 0..40), Arb.int(-10..110), Arb.int(0..5)) { list, x, distance ->
            val near = timelineOf(list).at(x.toDouble(), distance.toDouble())
            val expected = list.filter { x >= it.spans[0].from - distance && x <= it.spans[0].to + distance }
            near.toSet() shouldBe expected.toSet()
        }
        timeline.at(Double.NaN, 1.0) shouldBe emptyList()
    }

    test("a pointer finds the nearest mark, otherwise the worst finding that lasts there") {
        timeline.pointedAt(51.5, 1.0, all)?.name shouldBe "Middle"
        timeline.pointedAt(25.0, 0.1, all)?.name shouldBe "Early"
        timeline.pointedAt(5.0, 1.0, all) shouldBe null
        timeline.pointedAt(70.0, 1.0, Span(61.0, 75.0))?.name shouldBe "Middle"
        timeline.at(90.0, 0.5).map { it.name } shouldContainExactly listOf("Middle", "Late")
    }

    test("pixels with findings have the severity of the worst") {
        val marks = FindingMarks()
        marks.place(timeline, all, 100.0, 1.0)
        List(marks.runCount) { Triple(marks.runFrom(it).toInt(), marks.runTo(it).toInt(), marks.runSeverity(it)) } shouldContainExactly listOf(
            Triple(0, 21, null),
            Triple(21, 31, Severity.ERROR),
            Triple(31, 51, null),
            Triple(51, 100, Severity.WARNING),
        )
        marks.place(timeline, Span(0.0, 10.0), 100.0, 1.0)
        List(marks.runCount) { marks.runSeverity(it) } shouldBe listOf(null)
        marks.place(timeline, all, 0.0, 1.0)
        marks.runCount + marks.size shouldBe 0
    }

    /** The [pixels], which ascend, without those that would hide the one before. */
    fun apart(pixels: List<Double>, distance: Double) = pixels.fold(emptyList<Double>()) { kept, pixel -> if (kept.isEmpty() || pixel - kept.last() >= distance) kept + pixel else kept }

    test("visible starts have the glyph of their severity, the worst drawn last, and glyphs and lines keep their distance") {
        val marks = FindingMarks()
        checkAll(Arb.list(found, 0..40), Arb.int(1..200), Arb.int(1..3)) { list, columns, onePixel ->
            marks.place(timelineOf(list), all, columns * onePixel.toDouble(), onePixel.toDouble())
            for (severity in Severity.entries) {
                val pixels = list.filter { it.severity == severity && it.spans[0].from in all }
                    .map { kotlin.math.floor(it.spans[0].from / 100 * columns) * onePixel }.sorted()
                (0 until marks.size).filter { marks.severityOf(it) == severity }.map { marks.pixelOf(it) } shouldBe apart(pixels, 4.0 * onePixel)
            }
            List(marks.size) { marks.severityOf(it) }.zipWithNext().all { (one, next) -> one <= next } shouldBe true
            for (severity in Severity.entries) {
                val lines = (0 until marks.size).filter { marks.severityOf(it) == severity && marks.hasLine(it) }.map { marks.pixelOf(it) }
                lines.zipWithNext().all { (one, other) -> other - one >= 9 * onePixel } shouldBe true
            }
        }
    }
})
