package badlog.signals.derived

import badlog.core.analysis.Series
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import kotlin.math.abs

class MechanismSensorsSpec : FunSpec({
    val times = timesFor(60)
    val turned = times.of { 25 * swing(it) }
    fun error(moved: (Double) -> Double) = couplingError(times, turned, times.of(moved), times.always())

    test("a mechanism that moves with its motor has no coupling error; one that slips has, in percent of its range") {
        abs(error { 90 * swing(it) }.most()) shouldBeLessThan 1e-6
        error { 90 * swing(it) + if (it < 40) 0.0 else 18.0 }.most(from = 41.0) shouldBe (9.0 plusOrMinus 1.0)
    }

    test("a motor whose position is no longer read does not slip while its mechanism moves on") {
        // It is lost while it rests.
        fun moved(time: Double) = swing(if (time in 27.0..29.0) 27.0 else time)
        val lost = times.of { 25 * moved(if (it in 28.0..40.0) 28.0 else it) }
        couplingError(times, lost, times.of { 90 * moved(it) }, times.always()).most(to = 39.9) shouldBeLessThan 3.0
        error { 90 * swing(it) + if (it < 40) 0.0 else 18.0 }.most(from = 41.0) shouldBeGreaterThan 8.0
    }

    test("a motor that hardly moved does not show a coupling") {
        couplingError(times, times.of { 0.0 }, times.of { swing(it) }, times.always()).size shouldBe 0
    }

    test("the motor of an encoder is the only one that turns with it") {
        val other = times.of { 25 * swing(it, 5.0) }
        val moved = times.of { 0.3 * swing(it) }
        coupledMotor(times, listOf(other, turned), moved, times.always()) shouldBe turned
        coupledMotor(times, listOf(other), moved, times.always()) shouldBe null
        coupledMotor(times, listOf(turned, turned.copyOf()), moved, times.always()) shouldBe null
    }

    test("an encoder that begins again after each turn is of no motor") {
        val moved = times.of { it % 1.0 }
        coupledMotor(times, listOf(times.of { it }), moved, times.always()) shouldBe null
    }

    test("a sensor that stands still while its motor turns is frozen") {
        frozenWhileTurning(times, turned, times.of { if (it < 30) swing(it) else 0.4 }, times.always()).run {
            most(to = 29.0) shouldBe 0.0
            most(from = 31.0) shouldBe 1.0
        }
    }

    test("a single value of the motor that is taken back in the next sample freezes no sensor") {
        val resting = times.of { swing(minOf(it, 30.0)) }
        val misread = times.of { if (it in 32.0..32.01) 0.0 else 25 * swing(minOf(it, 30.0)) + 20 }
        frozenWhileTurning(times, misread, resting, times.always()).most() shouldBe 0.0
    }

    test("a motor that lags its sensor a little has no frozen sensor") {
        // Both stop at 30 s, but the motor's position is 0.04 s old.
        val late = times.of { 25 * swing(minOf(it - 0.04, 30.0), 0.7) }
        frozenWhileTurning(times, late, times.of { swing(minOf(it, 30.0), 0.7) }, times.always()).most() shouldBe 0.0
    }

    test("a reading that jumps to a value and keeps it is dead; one that moves there is not") {
        deadReading(times, times.of { if (it < 30.5) swing(it) else -3.0 }, times.always()).most() shouldBe 1.0
        deadReading(times, times.of { if (it < 31) swing(it) else -1.0 }, times.always()).most() shouldBe 0.0
    }

    test("a reading that falls ever faster to a stop and rests there is not dead") {
        fun fallen(seconds: Double) = 1 - 60 * seconds * seconds
        val falling = times.of { if (it < 30.0) 0.02 * swing(it) + 1 else maxOf(-1.85, fallen(it - 30)) }
        deadReading(times, falling, times.always()).most() shouldBe 0.0
    }

    test("a value that was misread once, and an angle that wraps to and fro, are not dead") {
        fun after(course: (Double) -> Double) = deadReading(times, times.of(course), times.always()).most(from = 30.5)
        after { if (it in 30.0..30.4) -3.0 else swing(minOf(it, 30.0)) } shouldBe 0.0
        after {
            if (it < 30) {
                swing(it)
            } else if ((it * 10).toInt() % 2 == 0) {
                -3.0 + 0.01 * it
            } else {
                3.0 - 0.01 * it
            }
        } shouldBe 0.0
    }

    test("a position that is set at a switch, where its motor stops, is not dead; one that its motor leaves is") {
        val set = times.of { if (it < 30.5) swing(it) else -3.0 }
        fun dead(output: (Double) -> Double) = deadReading(times, set, times.always(), listOf(times.series(output))).most()
        dead { if (it < 30.55) 0.5 else 0.0 } shouldBe 0.0
        dead {
            if (it < 30.55) {
                0.5
            } else if (it < 31.5) {
                0.0
            } else {
                0.2
            }
        } shouldBe 1.0
    }

    test("a switch that stays pressed is not contradicted by a position that only drifts, wherever it begins") {
        switchError(times, times.of { 5 + 0.005 * it }, times.of { 1.0 }, range = 1.0).most() shouldBeLessThan 11.0
    }

    test("a switch that reads pressed while the mechanism moves is contradicted") {
        val height = times.of { 1 - swing(it) }
        switchError(times, height, times.of { if (1 - swing(it) < 0.02) 1.0 else 0.0 }).most() shouldBeLessThan 3.0
        switchError(times, height, times.of { if (it > 30) 1.0 else 0.0 }).most() shouldBeGreaterThan 90.0
    }

    test("a switch counts as pressed once its position has come, too") {
        longPressed(timesFor(1), DoubleArray(50) { if (it in 10..20) 1.0 else 0.0 }).indices
            .filter { longPressed(timesFor(1), DoubleArray(50) { if (it in 10..20) 1.0 else 0.0 })[it] == 1.0 } shouldBe (13..20).toList()
    }

    test("something that is driven hard and does not turn is stalled; something that never turned is not") {
        val driven = times.of { if (it in 20.0..22.0) 40.0 else 10.0 }
        stall(times, times.of { if (it in 20.0..22.0) 0.0 else 100.0 }, driven, 12.0).run {
            most(to = 19.9) shouldBe 0.0
            most(20.0, 22.0) shouldBe 1.0
        }
        stall(times, times.of { 0.0 }, driven, 12.0).most() shouldBe 0.0
    }

    test("a current that stays exactly as it was while the motor still turned is left over from a motor that lost its power") {
        val speeds = times.of { if (it < 20) 100.0 else 0.0 }
        stall(times, speeds, times.of { if (it < 19) 10.0 else 40.0 }, 12.0).most() shouldBe 0.0
        stall(
            times,
            speeds,
            times.of {
                if (it < 19) {
                    10.0
                } else if (it < 21) {
                    40.0
                } else {
                    41.0
                }
            },
            12.0,
        ).run {
            most(to = 20.9) shouldBe 0.0
            most(from = 21.0) shouldBe 1.0
        }
    }

    test("a mechanism that holds a game piece is not stalled: it takes less than while it turns, gets less output, or does so again as far as is known") {
        fun stalled(amperes: Double, output: Double? = 0.75, isStill: (Double) -> Boolean = { it in 20.0..22.0 }): Double {
            val speeds = times.of { if (isStill(it)) 0.0 else 100.0 }
            return stall(times, speeds, times.of { if (isStill(it)) amperes else 25.0 }, 12.0, output?.let { own -> times.of { if (isStill(it)) own else 0.75 } }).most()
        }
        stalled(40.0) shouldBe 1.0
        stalled(22.0) shouldBe 0.0
        stalled(40.0, output = 0.3) shouldBe 0.0
        stalled(40.0) { it in 20.0..22.0 || it in 40.0..42.0 } shouldBe 1.0
        stalled(40.0, output = null) shouldBe 1.0
        stalled(40.0, output = null) { it in 20.0..22.0 || it in 40.0..42.0 } shouldBe 0.0
    }

    test("a mechanism that stands each way without turning in between is stalled; one that creeps in between, or is not driven the other way, is not") {
        fun stalled(between: Double, back: Double): Double {
            val speeds = times.of {
                if (it in 20.0..21.0 || it in 22.0..23.0) {
                    0.0
                } else if (it in 21.0..22.0) {
                    between
                } else {
                    100.0
                }
            }
            val outputs = times.of {
                if (it in 20.0..22.0) {
                    0.5
                } else if (it in 22.0..23.0) {
                    back
                } else {
                    1.0
                }
            }
            return stall(times, speeds, times.of { if (it in 20.0..23.0) 40.0 else 25.0 }, 12.0, outputs).most()
        }
        stalled(between = 0.0, back = -0.5) shouldBe 1.0
        stalled(between = 10.0, back = -0.5) shouldBe 0.0
        stalled(between = 0.0, back = 0.0) shouldBe 0.0
    }

    test("a position that is set where the switch closes jumps by its change beyond the movement") {
        // It goes down by 0.1 in each sample, and is set to 0 from 0.25 at the switch.
        val height = times.of { time ->
            (time % 4 * 50).let {
                if (it < 7.5) {
                    0.95 - 0.1 * it
                } else if (it < 150) {
                    0.0
                } else {
                    0.95
                }
            }
        }
        switchError(times, height, times.of { if (it % 4 * 50 in 7.5..149.5) 1.0 else 0.0 }).most() shouldBe (15.0 / 0.95 plusOrMinus 1.0)
    }

    test("a heading that jumps is off by the jump; a full turn, a fast turn or a single misread sample is not a jump") {
        fun jump(at: (Double) -> Double): Double = headingJump(Series(times, times.of(at)), 1.0).most()
        jump { 90 * swing(it, 8.0) + if (it > 30) 40.0 else 0.0 } shouldBe (40.0 plusOrMinus 4.0)
        jump { (300 * it) % 360 } shouldBe 0.0
        jump { 90 * swing(it, 8.0) + if (it in 30.0..30.01) 40.0 else 0.0 } shouldBe 0.0
    }
})
