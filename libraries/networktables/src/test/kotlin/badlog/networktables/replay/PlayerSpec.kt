package badlog.networktables.replay

import badlog.core.analysis.Series
import badlog.networktables.TopicType
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

private fun signal(vararg x: Double) = ReplayedTopic("/A", TopicType.DOUBLE, "V", Series(x, DoubleArray(x.size) { it.toDouble() }))

private fun player(vararg signals: ReplayedTopic, isLooping: Boolean = false, range: ClosedFloatingPointRange<Double> = 0.0..10.0) = Player(signals.toList(), Playhead(range, 1.0, 1.0, isLooping, nowNanos = 0))

private fun List<Update>.seen() = map { Triple(it.signal, it.index, it.micros) }

private const val SECOND = 1_000_000_000L

class PlayerSpec : FunSpec({
    test("at the start every signal has its current value") {
        val player = player(signal(-2.0, -1.0, 5.0), signal(1.0), signal(0.0, 0.0))
        player.advance(0).seen() shouldBe listOf(Triple(0, 1, 0L), Triple(2, 1, 0L))
        player.current(1) shouldBe null
    }

    test("samples of all signals are sent at their times, in one order") {
        val player = player(signal(1.0, 3.0), signal(2.0, 3.5))
        player.playhead.play(0)
        player.advance(3 * SECOND).seen() shouldBe
            listOf(Triple(0, 0, 1_000_000L), Triple(1, 0, 2_000_000L), Triple(0, 1, 3_000_000L))
        player.advance(9 * SECOND).seen() shouldBe listOf(Triple(1, 1, 3_500_000L))
        player.advance(10 * SECOND) shouldBe emptyList()
    }

    test("every sample is sent exactly once for any steps of time") {
        checkAll(
            200,
            Arb.list(Arb.double(0.0, 10.0, includeNaNs = false), 0..60),
            Arb.list(Arb.int(0..2_000), 20..40),
        ) { places, steps ->
            val player = player(signal(*places.sorted().toDoubleArray()))
            val all = ArrayList(player.advance(0).map { it.index })
            val before = places.count { it <= 0.0 }
            player.playhead.play(0)
            var now = 0L
            for (step in steps + 20_000) {
                now += step * 1_000_000L
                all += player.advance(now).map { it.index }
            }
            all shouldBe (maxOf(before - 1, 0) until places.size).toList()
        }
    }

    test("a new lap begins with the values at the start, at the time of the jump") {
        val player = player(signal(0.0, 4.0, 9.0), isLooping = true, range = 3.0..5.0)
        player.advance(0)
        player.playhead.play(0)
        player.advance(SECOND * 5 / 2).seen() shouldBe listOf(Triple(0, 1, 1_000_000L), Triple(0, 0, 2_000_000L))
    }

    test("after a jump back the earlier value is current again") {
        val player = player(signal(1.0, 2.0))
        player.playhead.play(0)
        player.advance(5 * SECOND)
        player.playhead.seek(1.5, 5 * SECOND)
        player.advance(5 * SECOND).seen() shouldBe listOf(Triple(0, 0, 5_000_000L))
    }
})
