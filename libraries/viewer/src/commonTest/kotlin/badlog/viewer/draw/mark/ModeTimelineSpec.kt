package badlog.viewer.draw.mark

import badlog.core.analysis.FlagReading
import badlog.core.analysis.FlagTopic
import badlog.core.analysis.LogView
import badlog.core.analysis.ModeTopics
import badlog.core.analysis.Span
import badlog.viewer.bagView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeGreaterThanOrEqual
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.checkAll

class ModeTimelineSpec : FunSpec({
    fun flag(name: String) = FlagTopic(name, FlagReading.Truth)

    fun timelineOf(vararg spans: Triple<Double, Double, RobotMode>) = ModeTimeline(spans.map { ModeSpan(Span(it.first, it.second), it.third) }, 1.0)

    val match = timelineOf(Triple(2.0, 17.0, RobotMode.AUTONOMOUS), Triple(19.0, 154.0, RobotMode.TELEOP), Triple(400.0, 410.0, RobotMode.TELEOP))

    test("modes follow from the vocabulary's topics, and are only “enabled” if no topic shows autonomous") {
        val view = bagView(listOf("Time|xaxis", "E", "A"), listOf("0,0,0", "1,1,1", "2,1,0", "3,0,0"))
        fun LogView.modesOf(modes: ModeTopics) = ModeTimeline.of(identified(null, modes)).spans.map { it.span to it.mode }
        view.modesOf(ModeTopics(flag("E"), flag("A"))) shouldBe
            listOf(Span(1.0, 2.0) to RobotMode.AUTONOMOUS, Span(2.0, 3.0) to RobotMode.TELEOP)
        view.modesOf(ModeTopics(flag("E"), null)) shouldBe listOf(Span(1.0, 3.0) to RobotMode.ENABLED)
        view.modesOf(ModeTopics.NONE) shouldBe emptyList()
    }

    test("test and utility are not teleop, and a phase has the name of its op mode") {
        val rows = listOf("0,0,unknown,", "1,1,autonomous,Two pieces", "2,1,teleoperated,Drive", "3,1,utility,Zero the arm", "4,0,unknown,")
        val view = bagView(listOf("Time|xaxis", "E", "Mode", "Op"), rows)
        val modes = ModeTopics(flag("E"), FlagTopic("Mode", FlagReading.Text("auto")), FlagTopic("Mode", FlagReading.Text("utility")), "Op")
        val timeline = ModeTimeline.of(view.identified(null, modes))
        timeline.spans.map { it.span to it.mode } shouldBe listOf(
            Span(1.0, 2.0) to RobotMode.AUTONOMOUS,
            Span(2.0, 3.0) to RobotMode.TELEOP,
            Span(3.0, 4.0) to RobotMode.UTILITY,
        )
        val clock = ModeTimeline(timeline.spans, 1.0)
        clock.clockAt(1.5) shouldBe "Auto (Two pieces) 0:00"
        clock.clockAt(3.5) shouldBe "Utility (Zero the arm) 0:02"
        val before = bagView(listOf("Time|xaxis", "E", "A", "T"), listOf("0,1,0,1", "1,0,0,0")).identified(null, ModeTopics(flag("E"), flag("A"), flag("T")))
        ModeTimeline.of(before).spans.map { it.mode } shouldBe listOf(RobotMode.TEST)
    }

    test("the match clock counts from the first enabling, also during the pause between phases, and restarts in the next match") {
        match.clockAt(2.0) shouldBe "Auto 0:00"
        match.clockAt(16.99) shouldBe "Auto 0:14"
        match.clockAt(18.0) shouldBe "Disabled 0:16"
        match.clockAt(85.4) shouldBe "Teleop 1:23"
        match.clockAt(200.0) shouldBe "Disabled"
        match.clockAt(0.0) shouldBe "Disabled"
        match.clockAt(405.0) shouldBe "Teleop 0:05"
        match.clockAt(Double.NaN) shouldBe null
        ModeTimeline(emptyList(), 1.0).clockAt(3.0) shouldBe null
        ModeTimeline(match.spans, null).clockAt(3.0) shouldBe null
    }

    test("bands show when the robot was enabled, and a shorter one than a pixel gets one") {
        val bands = ModeBands()
        bands.place(match, Span(0.0, 512.0), 64.0)
        List(bands.size) { Triple(bands.leftOf(it), bands.rightOf(it), bands.modeOf(it)) } shouldBe listOf(
            Triple(0.25, 2.125, RobotMode.AUTONOMOUS),
            Triple(2.375, 19.25, RobotMode.TELEOP),
            Triple(50.0, 51.25, RobotMode.TELEOP),
        )
        bands.place(match, Span(0.0, 5120.0), 64.0)
        bands.rightOf(2) - bands.leftOf(2) shouldBe 1.0
        bands.place(match, Span(20.0, 30.0), 100.0)
        bands.size shouldBe 1
        bands.leftOf(0) to bands.rightOf(0) shouldBe (0.0 to 100.0)
        bands.place(match, Span(160.0, 170.0), 100.0)
        bands.size shouldBe 0
    }

    test("spans of less than a pixel share one, even if its place has more digits than a number holds") {
        val bands = ModeBands()
        // 1.003 + 1 rounds to a number that is more than 1 from 1.003.
        val spans = List(40) { ModeSpan(Span(1.003 + it * 0.001, 1.003 + it * 0.001 + 0.0005), RobotMode.entries[it % 2]) }
        bands.place(ModeTimeline(spans, 1.0), Span(0.0, 10.0), 10.0)
        bands.size shouldBe 1
    }

    test("for any number of spans, there are at most as many bands as pixels, in order, and no visible one is lost") {
        val bands = ModeBands()
        checkAll(Arb.list(Arb.numericDouble(0.001, 3.0), 0..300), Arb.int(1..50), Arb.numericDouble(-5.0, 100.0), Arb.numericDouble(0.01, 300.0)) { gaps, width, from, length ->
            var x = 0.0
            val spans = gaps.chunked(2).filter { it.size == 2 }.mapIndexed { i, (pause, time) ->
                x += pause + time
                ModeSpan(Span(x - time, x), RobotMode.entries[i % 3])
            }
            val seen = Span(from, from + length)
            bands.place(ModeTimeline(spans, 1.0), seen, width.toDouble())
            bands.size shouldBeLessThanOrEqual 2 * width + 1
            for (i in 1 until bands.size) bands.leftOf(i) shouldBeGreaterThanOrEqual bands.rightOf(i - 1)
            for (one in spans) {
                if (one.span.to < seen.from || one.span.from > seen.to) continue
                val pixel = ((maxOf(one.span.from, seen.from) - from) / length * width).coerceIn(0.0, width - 1.0)
                (0 until bands.size).any { bands.leftOf(it) <= pixel + 1 && bands.rightOf(it) >= pixel } shouldBe true
            }
        }
    }
})
