package badlog.signals.battery

import badlog.core.analysis.Series
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.ln
import kotlin.math.sin
import kotlin.math.sqrt
import kotlin.random.Random

class ResistanceSpec : FunSpec({
    val times = DoubleArray(7500) { it * 0.02 }
    val amps = DoubleArray(times.size) { 60 + 50 * sin(2 * PI * times[it] / 3.1) + 20 * sin(2 * PI * times[it] / 17) }

    fun volts(noise: Double, seed: Int = 1): DoubleArray {
        val random = Random(seed)
        return DoubleArray(times.size) { 12.6 - 0.004 * times[it] - 0.018 * amps[it] + noise * (random.nextDouble() - 0.5) }
    }

    test("the resistance is the slope of voltage against current, even while the battery empties") {
        val found = resistanceOf(Series(times, volts(0.05)), Series(times, amps), times.last()).shouldNotBeNull()
        found.milliohms shouldBe (18.0 plusOrMinus 0.6)
        abs(found.milliohms - 18) shouldBeLessThan found.uncertainty + 0.2
        found.uncertainty shouldBeLessThan 1.5
    }

    test("a log of changes has the same resistance") {
        val steps = DoubleArray(times.size) { kotlin.math.floor(times[it] / 1.5) % 4 * 50 }
        val fallen = DoubleArray(times.size) { 12.6 - 0.02 * steps[it] }
        val changes = times.indices.filter { it == 0 || steps[it] != steps[it - 1] }
        fun sparse(all: DoubleArray) = Series(DoubleArray(changes.size) { times[changes[it]] }, DoubleArray(changes.size) { all[changes[it]] })
        val rows = resistanceOf(Series(times, fallen), Series(times, steps), times.last()).shouldNotBeNull()
        val sparseOnes = resistanceOf(sparse(fallen), sparse(steps), times.last()).shouldNotBeNull()
        sparseOnes.milliohms shouldBe (rows.milliohms plusOrMinus 0.5)
        rows.milliohms shouldBe (20.0 plusOrMinus 0.01)
    }

    test("of 300 batteries, 93 to 97 % have the resistance that is stated, within its uncertainty") {
        val random = Random(7)

        /** Draws a normal distribution, by the polar method. */
        fun normal(): Double {
            while (true) {
                val x = 2 * random.nextDouble() - 1
                val y = 2 * random.nextDouble() - 1
                val square = x * x + y * y
                if (square < 1 && square > 0) return x * sqrt(-2 * ln(square) / square)
            }
        }

        var covered = 0
        repeat(300) { number ->
            val ohms = 0.010 + 0.02 * random.nextDouble()
            val noise = listOf(0.02, 0.05, 0.15)[number % 3]
            val every = listOf(1, 4, 5)[number / 3 % 3]
            // A robot draws power in bursts, which motors follow within tenths of a second.
            val drawn = DoubleArray(times.size)
            var level = 0.0
            var until = 0
            var now = 0.0
            for (i in drawn.indices) {
                if (i >= until) {
                    level = listOf(2.0, 20.0, 60.0, 60.0, 120.0, 200.0)[random.nextInt(6)] * (0.7 + 0.6 * random.nextDouble())
                    until = i + 5 + (-60 * ln(1 - random.nextDouble())).toInt()
                }
                now += (level - now) * 0.13
                drawn[i] = now
            }
            val volts = DoubleArray(times.size) { 12.7 - 0.5 * times[it] / times.last() - ohms * drawn[it] + noise * normal() }
            val read = times.indices.filter { it % every == 0 }
            val current = Series(DoubleArray(read.size) { times[read[it]] }, DoubleArray(read.size) { drawn[read[it]] })
            val found = resistanceOf(Series(times, volts), current, times.last()).shouldNotBeNull()
            if (abs(found.milliohms - 1000 * ohms) <= found.uncertainty) covered++
        }
        covered shouldBeInRange 279..291
    }

    test("there is no resistance if its uncertainty is a fifth of it or more") {
        val rows = 2500
        val uneven = DoubleArray(rows) { 12.6 - (if (times[it] in 20.0..30.0) 0.08 else 0.0) * amps[it] }
        val x = times.copyOf(rows)
        resistanceOf(Series(x, uneven), Series(x, amps.copyOf(rows)), x.last()).shouldBeNull()
    }

    test("there is no resistance if the current hardly changes, if there are only a few seconds, or without a voltage") {
        resistanceOf(Series(times, volts(0.05)), Series(times, DoubleArray(times.size) { 5 + it % 3.0 }), times.last()).shouldBeNull()
        val few = DoubleArray(500) { times[it] }
        resistanceOf(Series(few, volts(0.0).copyOf(500)), Series(few, amps.copyOf(500)), few.last()).shouldBeNull()
        resistanceOf(Series(times, DoubleArray(times.size)), Series(times, amps), times.last()).shouldBeNull()
        resistanceOf(Series(DoubleArray(0), DoubleArray(0)), Series(times, amps), times.last()).shouldBeNull()
    }
})
