package badlog.signals.derived

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlin.math.abs

class MissedPullsSpec : FunSpec({
    val times = timesFor(90)

    /** The currents of both sides of a drive, which pull for some seconds at a time. */
    fun drive(time: Double) = 30 * abs(swing(time))

    fun most(own: (Double) -> Double, other: (Double) -> Double, isEnabled: BooleanArray = times.always()): Double {
        val missed = missedPulls(times, listOf(times.of(own), times.of(other)), isEnabled, 40.0)
        return missed[0]?.max() ?: 0.0
    }

    fun tripped(time: Double) = when {
        time < 49 -> drive(time)
        time < 50 -> 60.0
        else -> 0.0
    }

    test("a channel that no longer pulls while its equal does has missed that many seconds") {
        most(::tripped, ::drive) shouldBeGreaterThan 10.0
    }

    test("a breaker that closes again has missed pulls until then") {
        most({ if (it < 75) tripped(it) else drive(it) }, ::drive) shouldBeGreaterThan 5.0
        most({ if (it < 57) tripped(it) else drive(it) }, ::drive) shouldBe 0.0
    }

    test("a channel has missed no pull if its equal rests, too") {
        most(::tripped, { if (it < 49) drive(it) else 2.0 }) shouldBe 0.0
    }

    test("a mechanism that rests after a pull has no equal: the drive continues without it") {
        most({ if (it < 50 && it % 12 > 9) 60.0 else 0.0 }, ::drive) shouldBe 0.0
    }

    test("without a hard pull, or disabled, a channel just rests") {
        most({ if (it < 50) drive(it) else 0.0 }, ::drive) shouldBe 0.0
        most(::tripped, ::drive, BooleanArray(times.size) { times[it] < 55 }) shouldBe 0.0
    }
})
