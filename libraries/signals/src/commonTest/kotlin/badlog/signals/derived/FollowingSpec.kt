package badlog.signals.derived

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import kotlin.math.cos
import kotlin.math.exp
import kotlin.random.Random

class FollowingSpec : FunSpec({
    val times = timesFor(40)

    /** 0 and 1 in turns of 8 s. */
    val target = times.of { (it / 8).toInt() % 2.0 }

    fun following(measured: (Double) -> Double, wanted: DoubleArray = target) = Following(times, wanted, times.of(measured), times.always())

    /** A measurement that follows the target within half a second. */
    fun followed(time: Double): Double {
        val since = time % 8
        val now = (time / 8).toInt() % 2.0
        return if (time < 8 || since > 0.5) now else 1 - now + (2 * now - 1) * since / 0.5
    }

    test("a measurement that follows its target misses nothing, and one that stays away is off by a share of the range") {
        following(::followed).missed().most() shouldBeLessThan 5.0
        following({ if (it < 20) followed(it) else 0.7 * followed(it) }).missed().most(from = 25.0, to = 31.9) shouldBe (30.0 plusOrMinus 0.1)
    }

    test("a measurement that never reaches its targets is of something else: a drum's angle is not the elevator's height") {
        following({ 4.5 * followed(it) }).run { listOf(missed(), overshoot(), shortfall()) }.forEach { it.size shouldBe 0 }
    }

    test("a target without values for a time is not missed during it") {
        val gaps = DoubleArray(times.size) { if (times[it] in 10.0..12.0) Double.NaN else target[it] }
        following(::followed, gaps).missed().most() shouldBeLessThan 5.0
    }

    test("nothing follows a target that is always 0 or has no values") {
        for (wanted in listOf(0.0, Double.NaN)) following(::followed, times.of { wanted }).missed().size shouldBe 0
    }

    test("nothing is missed while the robot is disabled") {
        Following(times, target, times.of { 0.0 }, BooleanArray(times.size)).missed().most().isNaN() shouldBe true
    }

    test("beyond a new target is an overshoot, in percent of the step") {
        val beyond = following({ followed(it) + if (it % 8 in 0.5..1.0 && followed(it) == 1.0) 0.3 else 0.0 })
        beyond.overshoot().most() shouldBe (30.0 plusOrMinus 0.1)
        following(::followed).overshoot().most() shouldBe 0.0
    }

    test("a constant speed target is missed by a share of itself, but not while the wheel spins up") {
        val speed = times.of { 4000.0 }
        following({ 3600.0 }, speed).shortfall().most() shouldBe (10.0 plusOrMinus 0.1)
        following({ if (it < 3) 1000 * it else 4000.0 }, speed).shortfall().most() shouldBeLessThan 0.1
    }

    test("a speed that goes to both sides of its target swings; one that falls with each shot does not") {
        val speed = times.of { 4000.0 }
        following({ 4000 + 100 * swing(it, 0.8) }, speed).swing().most() shouldBeGreaterThan 4.0
        following({ 4000 - if (it % 2 < 0.3) 400.0 else 0.0 }, speed).swing().most().isNaN() shouldBe true
        // Between shots it is a little too fast.
        following({ 4000 - if (it % 1 < 0.3) 400.0 else -60.0 }, speed).swing().most().isNaN() shouldBe true
    }

    test("noise around a target is no swing, however large: a wheel does not turn back from one value to the next") {
        val random = Random(1)
        val noise = DoubleArray(times.size) { 60 * (random.nextDouble() - 0.5) + 60 * (random.nextDouble() - 0.5) }
        val speed = times.of { 1500.0 }
        fun swings(size: Double) = Following(times, speed, DoubleArray(times.size) { 1500 + noise[it] + size * swing(times[it], 0.8) }, times.always()).swing()
        swings(0.0).most().isNaN() shouldBe true
        swings(100.0).most() shouldBeGreaterThan 10.0
    }

    test("a place swings by a share of its range, also around 0") {
        val place = times.of { if (it < 30) 0.0 else 1.0 }
        val swing = following({ (if (it < 30) 0.0 else 1.0) + 0.05 * swing(it, 0.5) }, place).placeSwing()
        swing.most(to = 29.0) shouldBe (9.0 plusOrMinus 1.5)
        swing.most(from = 35.0) shouldBe (9.0 plusOrMinus 1.5)
        // It went to a single target, and its sensor's steps are as large beside that as a swing.
        following({ if (it < 5) 100.0 else 1.0 + 0.05 * swing(it, 0.5) }, times.of { 1.0 }).placeSwing().most().isNaN() shouldBe true
        following({ if (it < 30) 0.0 else 1.0 - exp(30 - it) * cos(6 * it) }, place).placeSwing().most(from = 36.0).isNaN() shouldBe true
    }
})
