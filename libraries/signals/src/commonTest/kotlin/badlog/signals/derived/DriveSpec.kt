package badlog.signals.derived

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sign

class DriveSpec : FunSpec({
    val times = timesFor(60)

    test("a module that stays where it was is off its angle, one that drives backward instead of turning round is not") {
        val target = times.of { swing(it) }
        fun error(at: Int, own: (Double) -> Double) = moduleAngleError(
            at,
            times,
            List(4) { module -> if (module == 2) times.of(own) else target },
            List(4) { target },
            List(4) { times.of { 1.0 } },
            times.always(),
        ).most()
        error(2) { 0.0 } shouldBe (180 / PI plusOrMinus 0.1)
        error(2) { swing(it) + PI } shouldBeLessThan 1e-6
        error(0) { 0.0 } shouldBeLessThan 1e-6
    }

    test("a module that is further behind its target than the others lags, whatever the others have to turn; late measurements are not a lag") {
        val turns = listOf(1.0, 1.0, 1.4, 1.4)
        val targets = turns.map { much -> times.of { much * swing(2 * it) } }
        fun lags(behind: (Int) -> Double) = moduleAngleLags(
            times,
            turns.mapIndexed { at, much -> times.of { much * swing(2 * (it - behind(at))) } },
            targets,
            List(4) { times.of { 1.0 } },
            times.always(),
        )
        val slow = checkNotNull(lags { if (it == 1) 0.05 else 0.03 })
        checkNotNull(slow[1]) shouldBe (5.0 / 3 plusOrMinus 0.2)
        slow[0] shouldBe null
        checkNotNull(lags { 0.03 }).forEach { checkNotNull(it) shouldBe (1.0 plusOrMinus 0.03) }
        moduleAngleLags(times, targets, targets, List(4) { times.of { 0.0 } }, times.always()) shouldBe null
    }

    test("angles come seldom if they change in each fifth loop only") {
        isSeldom(times, listOf(times.of { swing(it) })) shouldBe false
        isSeldom(times, listOf(times.of { swing((it * 10).toInt() / 10.0) })) shouldBe true
    }

    test("a wheel that turns slower than the others in straight driving has less than its share") {
        val angles = List(4) { times.of { 0.3 } }
        val shares = moduleSpeedShares(List(4) { at -> times.of { if (at == 1) 1.9 else 2.0 } }, angles)
        checkNotNull(shares)[1] shouldBe (0.95 plusOrMinus 1e-6)
        moduleSpeedShares(List(4) { times.of { 0.0 } }, angles) shouldBe null
    }

    test("a drive motor's current is a share of the others', if those are alike") {
        fun shares(vararg amperes: Double) = currentShares(times, amperes.map { own -> times.of { own } }, times.always())
        checkNotNull(shares(20.0, 10.0, 20.0, 20.0))[1] shouldBe 0.5
        // Wheels that work against each other take more and less.
        checkNotNull(shares(20.0, 10.0, 32.0, 35.0))[1] shouldBe null
        shares(0.1, 0.1, 0.1, 0.1) shouldBe null
    }

    test("a channel that takes less than before has lost its share of the four drive motors, which more and less current flows to alike") {
        /** Four drive motors, a compressor that draws more, and two motors that draw at other moments. */
        fun changes(change: (at: Int, time: Double) -> Double) = channelChanges(
            times,
            List(7) { at ->
                times.of { time ->
                    when {
                        at < 4 -> (10 + 8 * swing(time)) * change(at, time)
                        at == 4 -> 20.0
                        else -> 12 + 9 * swing(time, period = 2.9)
                    }
                }
            },
            times.always(),
        )
        val lost = checkNotNull(changes { at, time -> if (at == 2 && time > 20) 0.4 else 1.0 })
        checkNotNull(lost[2]) shouldBe (0.4 plusOrMinus 0.02)
        lost.filterIndexed { at, _ -> at != 2 } shouldBe List(6) { null }
        // Wheels that work against each other change unlike each other.
        checkNotNull(changes { at, time -> if (time > 20) listOf(0.6, 1.0, 1.5, 1.0)[at] else 1.0 })[0] shouldBe null
        changes { at, _ -> if (at == 1) 2.0 else 1.0 } shouldBe null
    }

    test("a side of a tank drive that needs more output at the same speed drags") {
        val speed = times.of { 3 * swing(it) }
        fun side(friction: Double) = Side(times.of { 0.8 * swing(it) + friction * sign(swing(it)) }, speed)
        checkNotNull(sideFriction(times, side(0.1), side(0.02))) shouldBe (0.08 plusOrMinus 0.01)
        sideFriction(times, Side(speed, times.of { 0.0 }), side(0.1)) shouldBe null
    }

    test("a voltage that its current explains is not lost; a dip without current is") {
        val amperes = times.series { abs(60 * swing(it)) + if ((it * 50).toInt() % 2 == 0) 0.5 else 0.0 }
        fun lost(dip: Double): Double {
            val battery = times.series { 12.5 - 0.02 * abs(60 * swing(it)) - if (it in 30.0..30.2) dip else 0.0 }
            return unexplainedDrop(battery, amperes).most()
        }
        lost(0.0) shouldBe 0.0
        lost(4.0) shouldBeGreaterThan 2.0
    }

    test("stored air that falls while nothing uses it is lost, and a compressor that raises nothing has no gain") {
        val off = times.series { 0.0 }
        airLoss(times.series { 110 - 0.5 * it }, off).most() shouldBe (0.5 plusOrMinus 0.05)
        airLoss(times.series { 110 - 5.0 * (it / 10).toInt() }, off).most() shouldBeLessThan 0.1
        // A small cylinder moves once a second.
        airLoss(times.series { 110 - 2.2 * it.toInt() }, off).most() shouldBeLessThan 0.1
        // Ten samples a second spread its drops.
        val rare = DoubleArray(600) { it / 10.0 }
        airLoss(rare.series { 110 - 2.2 * it.toInt() }, off).y.none { it.isFinite() } shouldBe true
        airGain(times.series { 90.0 }, times.series { 1.0 }).most() shouldBe 0.0
        airGain(times.series { 90 + it }, times.series { 1.0 }).most() shouldBeGreaterThan 0.9
    }
})
