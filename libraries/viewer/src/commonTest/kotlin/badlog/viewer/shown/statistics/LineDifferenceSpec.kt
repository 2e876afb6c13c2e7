package badlog.viewer.shown.statistics

import badlog.core.analysis.Series
import badlog.core.analysis.Span
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.filter
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sin
import kotlin.math.sqrt

class LineDifferenceSpec : FunSpec({
    val times = DoubleArray(3001) { it * 0.01 }
    fun line(value: (Double) -> Double) = Series(times, DoubleArray(times.size) { value(times[it]) })
    val all = listOf(Span(0.0, 30.0))

    test("a constant difference is mean, RMS and largest one, and has no lag") {
        val found = differenceOf(line { sin(it) + 2 }, line { sin(it) }, all, "V").shouldNotBeNull()
        for (each in listOf(found.mean, found.rms, found.largest)) each shouldBe (2.0 plusOrMinus 1e-9)
        found.lag.shouldBeNull()
    }

    test("a late line has its delay as the lag, and the other way round is ahead") {
        val target = line { sin(it) + sin(2.3 * it) }
        val follower = line { sin(it - 0.12) + sin(2.3 * (it - 0.12)) }
        differenceOf(follower, target, all, "m/s").shouldNotBeNull().lag.shouldNotBeNull() shouldBe (0.12 plusOrMinus 0.01)
        differenceOf(target, follower, all, "m/s").shouldNotBeNull().lag.shouldNotBeNull() shouldBe (-0.12 plusOrMinus 0.01)
    }

    test("a motor that turns by a full turn between two samples is not an angle") {
        differenceOf(line { 100 * it + 3.2 }, line { 100 * it }, all, "rot").shouldNotBeNull().mean shouldBe (3.2 plusOrMinus 1e-6)
    }

    test("a line has no lag behind itself") {
        differenceOf(line { sin(it) }, line { sin(it) }, all, "m/s").shouldNotBeNull().lag.shouldBeNull()
    }

    test("a line that holds its last value is compared until the end") {
        val target = Series(doubleArrayOf(0.0), doubleArrayOf(3.0))
        differenceOf(line { 1.0 }, target, all, "V", endOfOther = 30.0).shouldNotBeNull().mean shouldBe (-2.0 plusOrMinus 1e-9)
        differenceOf(line { 1.0 }, target, all, "V").shouldBeNull()
    }

    test("lines of different shape have no lag") {
        differenceOf(line { sin(it) }, line { sin(5 * it) }, all, "m/s").shouldNotBeNull().lag.shouldBeNull()
    }

    test("the largest difference has its place and its sign") {
        val found = differenceOf(line { if (it in 10.0..10.5) -3.0 else 1.0 }, line { 0.0 }, all, "A").shouldNotBeNull()
        found.largest shouldBe -3.0
        found.largestAt shouldBe (10.0 plusOrMinus 0.011)
    }

    for ((unit, turn) in listOf("deg" to 360.0, "rad" to 2 * PI, "rot" to 1.0)) {
        test("for angles in $unit, the shorter way counts, unless they count turns") {
            fun angle(turns: Double) = (turns - kotlin.math.round(turns)) * turn
            differenceOf(line { angle(0.3 * it + 0.01) }, line { angle(0.3 * it) }, all, unit).shouldNotBeNull().run {
                mean shouldBe (0.01 * turn plusOrMinus 1e-9)
                largest shouldBe (0.01 * turn plusOrMinus 1e-9)
            }
            differenceOf(line { it * turn + turn }, line { it * turn }, all, unit).shouldNotBeNull().mean shouldBe (turn plusOrMinus 1e-9)
            differenceOf(line { 0.2 * turn }, line { 0.9 * turn }, all, unit).shouldNotBeNull().mean shouldBe (-0.7 * turn plusOrMinus 1e-9)
        }
    }

    test("a difference counts as long as it holds, for any times of the samples, and only within the parts") {
        val one = Series(doubleArrayOf(0.0, 1.0, 9.0, 10.0), doubleArrayOf(4.0, 1.0, 5.0, 5.0))
        val other = Series(doubleArrayOf(0.0, 10.0), doubleArrayOf(0.0, 0.0))
        val found = differenceOf(one, other, listOf(Span(0.0, 10.0)), "V").shouldNotBeNull()
        found.mean shouldBe (1.7 plusOrMinus 1e-12)
        found.rms shouldBe (sqrt(4.9) plusOrMinus 1e-12)
        differenceOf(one, other, listOf(Span(0.0, 1.0), Span(9.0, 10.0)), "V").shouldNotBeNull().mean shouldBe (4.5 plusOrMinus 1e-12)
    }

    test("lines without common samples, gaps, and x that goes backwards have no difference") {
        val line = Series(doubleArrayOf(0.0, 1.0), doubleArrayOf(1.0, 2.0))
        differenceOf(line, Series(doubleArrayOf(5.0, 6.0), doubleArrayOf(1.0, 2.0)), all, "V").shouldBeNull()
        differenceOf(line, Series(DoubleArray(0), DoubleArray(0)), all, "V").shouldBeNull()
        differenceOf(line, Series(doubleArrayOf(0.0, 1.0), doubleArrayOf(Double.NaN, 1.0)), all, "V").shouldBeNull()
        differenceOf(line, Series(doubleArrayOf(1.0, 0.0), doubleArrayOf(1.0, 1.0)), all, "V").shouldBeNull()
    }

    test("the mean is never farther from 0 than the RMS, and the RMS never farther than the largest difference") {
        val samples = Arb.list(Arb.double(0.0, 30.0).filter { it.isFinite() }, 2..40)
        checkAll(samples, samples) { a, b ->
            val one = Series(a.sorted().toDoubleArray(), DoubleArray(a.size) { a[it] })
            val other = Series(b.sorted().toDoubleArray(), DoubleArray(b.size) { b[it] })
            val found = differenceOf(one, other, all, "V") ?: return@checkAll
            (abs(found.mean) <= found.rms + 1e-9) shouldBe true
            (found.rms <= abs(found.largest) + 1e-9) shouldBe true
        }
    }
})
