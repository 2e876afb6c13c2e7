package badlog.viewer

import badlog.core.analysis.Downsampling
import badlog.core.analysis.LogView
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.statistics
import badlog.core.recording.Value
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.boardOfText
import badlog.viewer.choices.board.toText
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.axis.Ticks
import badlog.viewer.draw.mark.Clocks
import badlog.viewer.draw.mark.ModeSpan
import badlog.viewer.draw.mark.ModeTimeline
import badlog.viewer.draw.mark.RobotMode
import badlog.viewer.session.video.VideoAlignment
import badlog.viewer.text.cursorText
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import kotlin.math.sin

/** From 2027 on, a robot's clock counts from the boot of its computer. A log may then begin after a day. */
private const val BOOT = 86_400.0

/** A column without a sample is NaN, which equals nothing in JavaScript. */
private fun numbers(values: DoubleArray) = values.map { value -> value.takeUnless { it.isNaN() } }

class LateClockSpec : FunSpec({
    // No sample is at the edge of a pixel.
    fun wave(from: Double) = Series(DoubleArray(5000) { from + it * 0.02 + 0.0013 }, DoubleArray(5000) { 100 * sin(it / 50.0) })
    val early = wave(0.0)
    val late = wave(BOOT)

    test("the statistics of a range are the same as in a log with a clock that began with it") {
        for ((from, to) in listOf(0.0 to 100.0, 20.0 to 20.5, 33.0 to 33.03)) {
            val own = late.statistics(from + BOOT, to + BOOT)
            val other = early.statistics(from, to)
            own.count shouldBe other.count
            val (numbers, wanted) = listOf(own, other).map {
                listOf(it.min, it.max, it.mean, it.standardDeviation, it.percentile5, it.median, it.percentile95, it.first, it.last, it.integral)
            }
            for ((number, other) in numbers zip wanted) number shouldBe (other plusOrMinus 1e-6)
        }
    }

    test("a graph is the same, from the whole log down to a tenth of a second") {
        for ((from, to) in listOf(0.0 to 100.0, 40.0 to 50.0, 60.0 to 60.1)) {
            val own = PixelColumns(500).also { Downsampling(late).fill(from + BOOT, to + BOOT, it) }
            val other = PixelColumns(500).also { Downsampling(early).fill(from, to, it) }
            own.samples.toList() shouldBe other.samples.toList()
            numbers(own.min) shouldBe numbers(other.min)
            numbers(own.max) shouldBe numbers(other.max)
        }
    }

    test("the ticks of the x axis have different texts, even a millisecond apart") {
        for (width in listOf(160.0, 1.0, 0.01)) {
            val ticks = Ticks.ofX(Span(BOOT + 12.5, BOOT + 12.5 + width), 900.0)
            (ticks.texts.size > 2) shouldBe true
            ticks.texts.shouldBeUnique()
        }
    }

    test("zooming keeps the place under the mouse, down to a millisecond, and the range stays in the log") {
        val whole = Viewport(Span(BOOT, BOOT + 160))
        val center = BOOT + 93.7
        var zoomed = whole
        repeat(40) { zoomed = zoomed.scaled(0.75, center) }
        zoomed.visible.width shouldBe (160 * 0.00001005663 plusOrMinus 1e-4)
        (center in zoomed.visible) shouldBe true
        zoomed.shifted(-1000.0).visible.from shouldBe BOOT
        zoomed.reset().visible shouldBe whole.full
    }

    test("a visible range in a link is exact") {
        val visible = Span(BOOT + 93.123456, BOOT + 93.654321)
        val board = Board().withGraph(listOf("A", "B")).withXy(1, true).withPlane(1, visible, visible)
        boardOfText(board.toText()).graphs.map { it.xRange } shouldBe listOf(visible)
    }

    test("the time of day counts from the log's first sample, and the match clock from the enabling of the robot") {
        val rows = listOf("${BOOT + 10},1", "${BOOT + 200},1")
        val view = bagView(listOf("Time|xaxis", "A"), rows)
        val topics = view.recording.topics.map { if (it.name == "Time") it.copy(unit = "s") else it }
        val started = LogView.of(view.recording.copy(topics = topics, values = listOf(Value("Start Time", "2027-03-06 15:00:00 UTC"))))
        val match = ModeTimeline(listOf(ModeSpan(Span(BOOT + 11, BOOT + 200), RobotMode.TELEOP, "Drive")), 1.0)
        val clocks = Clocks(started, match)
        clocks.textAt(BOOT + 94.6) shouldBe "Teleop (Drive) 1:23 · 15:01:24"
        cursorText(BOOT + 94.6, started.xAxis, 100.0, clocks.textAt(BOOT + 94.6)) shouldBe "86494.60 s · Teleop (Drive) 1:23 · 15:01:24"
    }

    test("a video is aligned to a tenth of a millisecond") {
        val alignment = VideoAlignment.of(12.3456, BOOT + 93.7001, 1.0)
        alignment.xAt(12.3456, 1.0) shouldBe (BOOT + 93.7001 plusOrMinus 1e-4)
        alignment.secondsAt(BOOT + 93.7001, 1.0) shouldBe (12.3456 plusOrMinus 1e-4)
    }
})
