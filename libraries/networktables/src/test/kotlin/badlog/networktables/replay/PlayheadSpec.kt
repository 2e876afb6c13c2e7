package badlog.networktables.replay

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import kotlin.math.abs

private const val SECOND = 1_000_000_000L

private fun playhead(range: ClosedFloatingPointRange<Double> = 0.0..10.0, speed: Double = 1.0, isLooping: Boolean = false) = Playhead(range, 1.0, speed, isLooping, nowNanos = 0)

private fun Playhead.stretches(nowNanos: Long) = ArrayList<Stretch>().also { list -> advance(nowNanos) { list += it } }

private val SPEEDS = Arb.double(0.01, 100.0, includeNaNs = false)

class PlayheadSpec : FunSpec({
    test("the playhead waits at the start until it is started") {
        val playhead = playhead()
        playhead.position(5 * SECOND) shouldBe 0.0
        playhead.play(5 * SECOND)
        playhead.position(7 * SECOND) shouldBe 2.0
    }

    test("the position is the elapsed time times the speed, and stays at the end") {
        checkAll(SPEEDS, Arb.int(0..100_000)) { speed, millis ->
            val playhead = playhead(speed = speed).apply { play(0) }
            val expected = minOf(millis / 1000.0 * speed, 10.0)
            playhead.position(millis * 1_000_000L) shouldBe (expected plusOrMinus 1e-9)
            playhead.isAtEnd(millis * 1_000_000L) shouldBe (expected >= 10.0)
        }
    }

    test("a looping position is the remainder of the distance, regardless of the number of calls") {
        checkAll(SPEEDS, Arb.list(Arb.int(0..5_000), 0..50)) { speed, steps ->
            val playhead = playhead(2.0..5.0, speed, isLooping = true).apply { play(0) }
            var now = 0L
            for (step in steps) {
                now += step * 1_000_000L
                playhead.stretches(now)
            }
            val expected = 2.0 + (now * 1e-9 * speed).mod(3.0)
            // The start and the end of a lap are the same moment.
            val apart = abs(playhead.position(now) - expected)
            minOf(apart, 3.0 - apart) shouldBe (0.0 plusOrMinus 1e-6)
        }
    }

    test("stretches join without a gap or an overlap, and end at the playhead") {
        checkAll(SPEEDS, Arb.boolean(), Arb.list(Arb.int(0..300), 0..100)) { speed, isLooping, steps ->
            val playhead = playhead(speed = speed, isLooping = isLooping).apply { play(0) }
            var now = 0L
            var at = 0.0
            var atNanos = 0L
            for (step in steps) {
                now += step * 1_000_000L
                for (stretch in playhead.stretches(now)) {
                    if (!stretch.isFresh) stretch.from shouldBe at
                    (stretch.to >= stretch.from) shouldBe true
                    val began = stretch.nanosAt(stretch.from)
                    (began >= atNanos - 1) shouldBe true
                    at = stretch.to
                    atNanos = stretch.nanosAt(stretch.to)
                    (atNanos <= now + 1) shouldBe true
                }
                at shouldBe playhead.position(now)
            }
        }
    }

    test("each position has the time at which the playhead reached it") {
        checkAll(SPEEDS, Arb.double(0.0, 10.0, includeNaNs = false)) { speed, position ->
            val playhead = playhead(speed = speed).apply { play(3 * SECOND) }
            val stretch = playhead.stretches(2000 * SECOND).single()
            playhead.position(stretch.nanosAt(position)) shouldBe (position plusOrMinus 1e-6)
        }
    }

    test("nothing is reported for a pause") {
        val playhead = playhead().apply { play(0) }
        playhead.stretches(SECOND)
        playhead.pause(SECOND)
        playhead.stretches(50 * SECOND) shouldBe emptyList()
        playhead.play(60 * SECOND)
        val stretch = playhead.stretches(61 * SECOND).single()
        (stretch.from to stretch.to) shouldBe (1.0 to 2.0)
        stretch.nanosAt(1.5) shouldBe 60 * SECOND + SECOND / 2
    }

    test("a jump is fresh and stays in the range") {
        val playhead = playhead().apply { play(0) }
        playhead.stretches(SECOND)
        playhead.seek(99.0, SECOND)
        val stretch = playhead.stretches(SECOND).single()
        stretch.isFresh shouldBe true
        (stretch.from to stretch.to) shouldBe (10.0 to 10.0)
        shouldThrow<IllegalArgumentException> { playhead.seek(Double.NaN, SECOND) }
    }

    test("after a change of speed, the position continues from the same place") {
        val playhead = playhead().apply { play(0) }
        playhead.changeSpeed(4.0, SECOND)
        playhead.position(2 * SECOND) shouldBe 5.0
        shouldThrow<IllegalArgumentException> { playhead.changeSpeed(0.0, SECOND) }
    }

    test("an hour between two calls is reported as one lap, not thousands") {
        val playhead = playhead(0.0..0.001, isLooping = true).apply { play(0) }
        playhead.stretches(0)
        playhead.stretches(3600 * SECOND).size shouldBe 2
    }

    test("a range without length is played once and not looped") {
        val playhead = playhead(3.0..3.0, isLooping = true).apply { play(0) }
        playhead.stretches(SECOND).single().isFresh shouldBe true
        playhead.isAtEnd(SECOND) shouldBe true
    }

    test("a range that is infinite, or ends before it begins, is refused") {
        shouldThrow<IllegalArgumentException> { playhead(2.0..1.0) }
        shouldThrow<IllegalArgumentException> { playhead(0.0..Double.POSITIVE_INFINITY) }
    }
})
