package badlog.viewer.session.video

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import kotlin.math.floor
import kotlin.math.round

class FrameClockSpec : FunSpec({
    val rates = Arb.element(15.0, 24.0, 25.0, 29.97, 30.0, 50.0, 59.94, 60.0, 120.0)

    /** The time when frame [index] begins in a file that stores whole milliseconds, as WebM does. */
    fun begin(index: Int, rate: Double) = round(index / rate * 1000) / 1000

    /** The frame that a player shows at [seconds]. */
    fun frameAt(seconds: Double, rate: Double) = floor(seconds * rate).toInt().let { near -> (near + 1 downTo near - 1).first { begin(it, rate) <= seconds } }

    test("after some played frames, even with skipped ones, each step moves by one frame, forward and back") {
        checkAll(rates, Arb.list(Arb.int(1..4), 8..40), Arb.int(10..5000)) { rate, gaps, start ->
            val clock = FrameClock()
            var frame = start
            clock.show(begin(frame, rate), isNext = false)
            for (gap in gaps + 1) {
                frame += gap
                clock.show(begin(frame, rate), isNext = true)
            }
            withClue("$rate per second: ${1 / clock.frameSeconds}") {
                for (count in listOf(-2, -1, 1, 2)) frameAt(clock.step(begin(frame, rate), count), rate) shouldBe frame + count
            }
        }
    }

    test("without a played frame, steps determine the duration of a frame") {
        checkAll(Arb.element(24.0, 25.0, 29.97, 30.0, 50.0, 59.94, 60.0), Arb.int(0..5000)) { rate, start ->
            val clock = FrameClock()
            clock.show(begin(start, rate), isNext = false)
            var at = frameAt(clock.step(begin(start, rate), 1), rate)
            while (at == start) {
                clock.lengthen()
                at = frameAt(clock.step(begin(start, rate), 1), rate)
            }
            at shouldBe start + 1
            clock.show(begin(at, rate), isNext = true)
            clock.frameSeconds shouldBe (1 / rate plusOrMinus 0.0011)
        }
    }

    test("neither a jump nor fast playback with skipped frames makes frames longer") {
        val clock = FrameClock()
        clock.show(1.0, isNext = false)
        clock.show(1.2, isNext = false)
        clock.show(1.2, isNext = true)
        clock.frameSeconds shouldBe 1.0 / 60
        for (time in listOf(1.32, 1.36, 1.40, 1.52)) clock.show(time, isNext = true)
        clock.frameSeconds shouldBe (0.04 plusOrMinus 1e-9)
    }

    test("no step goes before the video's start") {
        FrameClock().step(0.0, -1) shouldBe 0.0
    }
})
