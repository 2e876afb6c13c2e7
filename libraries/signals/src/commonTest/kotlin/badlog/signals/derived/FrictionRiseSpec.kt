package badlog.signals.derived

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import kotlin.math.abs
import kotlin.math.sign

class FrictionRiseSpec : FunSpec({
    val times = timesFor(90)
    val place = times.of { swing(it) }

    /** The effort that moves it: for its speed, its acceleration, its weight, and its friction. */
    fun effort(weight: (Double) -> Double = { 3.0 }, friction: (Double) -> Double) = times.of {
        5 * swing(it + 1) - 2 * swing(it) + weight(it) + friction(it) * sign(swing(it + 1))
    }

    fun rise(effort: DoubleArray) = frictionRise(times, place, effort, times.always())

    test("more effort in both directions is friction, as a share of the effort at first beside its speed") {
        checkNotNull(rise(effort { if (it < 30) 1.0 else 4.0 })) shouldBe (0.5 plusOrMinus 0.15)
        abs(checkNotNull(rise(effort { 1.0 }))) shouldBeLessThan 0.02
    }

    test("a load is not friction: it helps down as much as it hinders up") {
        abs(checkNotNull(rise(effort(weight = { if (it < 30) 3.0 else 12.0 }) { 1.0 }))) shouldBeLessThan 0.05
    }

    test("a mechanism that hardly moves, or not in both parts of the match, shows nothing") {
        frictionRise(times, times.of { 0.2 }, effort { 1.0 }, times.always()) shouldBe null
        frictionRise(times, times.of { if (it < 40) swing(it) else 0.0 }, effort { 1.0 }, times.always()) shouldBe null
        frictionRise(times, place, effort { 1.0 }, BooleanArray(times.size) { times[it] < 20 }) shouldBe null
    }

    test("a current with a sign has a direction, and a size has not") {
        hasDirection(effort { 1.0 }) shouldBe true
        hasDirection(DoubleArray(times.size) { abs(effort { 1.0 }[it]) }) shouldBe false
    }

    test("a motor that is slower than its output would turn it takes current from the battery, and one that is faster gives some back") {
        val speed = times.of { if (it < 80) 100.0 else 60.0 }
        val current = times.of { 20.0 }
        val supplied = suppliedCurrent(current, times.of { if (it < 85) 0.5 else 0.2 }, speed)
        supplied[4100] shouldBe (10.0 plusOrMinus 1e-9)
        supplied[4400] shouldBe (-4.0 plusOrMinus 1e-9)
        suppliedCurrent(current, times.of { -0.5 }, times.of { -100.0 }).min() shouldBeGreaterThan 0.0
    }
})
