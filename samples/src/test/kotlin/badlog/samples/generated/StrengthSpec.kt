package badlog.samples.generated

import badlog.samples.generated.fault.FAULTS
import badlog.samples.generated.fault.Naming
import badlog.samples.generated.robot.Action
import badlog.samples.generated.robot.Hardship
import badlog.samples.generated.robot.MatchObserver
import badlog.samples.generated.robot.MatchRun
import badlog.samples.generated.robot.RobotPlan
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeBetween
import kotlin.math.abs

private const val SEEDS = 3

/** Runs matches with the fault [id], and calls [watch] after each loop with the time since the fault's start. */
private fun watchMatches(id: String, strength: Double, watch: (MatchRun, Double) -> Unit) {
    for (seed in 1L..SEEDS) {
        val plan = RobotPlan.of(seed, Naming.ADVANTAGEKIT, FAULTS.first { it.id == id }, strength, Hardship.NONE)
        val run = MatchRun(plan)
        run.run(object : MatchObserver {
            override fun looped(time: Double) = watch(run, time - run.autoStart - checkNotNull(run.planting).start)

            override fun framed(time: Double) = Unit
        })
    }
}

/** Measures at the strengths 1 and 0.3, and compares with the ranges [clear] and [faint]. */
private fun atBoth(id: String, clear: ClosedRange<Double>, faint: ClosedRange<Double>, measure: (strength: Double) -> Double) {
    for ((strength, range) in listOf(1.0 to clear, 0.3 to faint)) {
        withClue("$id at $strength") { measure(strength).shouldBeBetween(range.start, range.endInclusive, 0.0) }
    }
}

/** Tests of the physical meaning of strengths, measured in the simulation. */
@Tags("InCheck")
class StrengthSpec : FunSpec({
    test("an oscillating shooter swings by about 9 % at 1, by about 3 % at 0.3") {
        atBoth("oscillating-controller", 0.06..0.13, 0.02..0.055) { strength ->
            var since = 0
            var most = 0.0
            watchMatches("oscillating-controller", strength) { run, time ->
                val shooter = checkNotNull(run.robot.shooter)
                val isBeforeShots = run.robot.driver.errand.action == Action.TRAVEL
                since = if (time > 1 && run.isEnabled && shooter.setpoint > 3000 && isBeforeShots) since + 1 else 0
                // After the wheel has reached its speed.
                if (since in 75..95) most = maxOf(most, abs(shooter.measured - shooter.setpoint) / shooter.setpoint)
            }
            most
        }
    }

    test("a shooter with a drag reaches 65 % of its speed at 1, 90 % at 0.3") {
        atBoth("shooter-slow", 0.58..0.72, 0.85..0.95) { strength ->
            var fastest = 0.0
            watchMatches("shooter-slow", strength) { run, time -> if (time > 2) fastest = maxOf(fastest, checkNotNull(run.robot.shooter).measured / 4000) }
            fastest
        }
    }

    test("an arm with wrong gains overshoots a step by 45 % at 1, by 13 % at 0.3") {
        atBoth("arm-overshoot", 0.3..0.75, 0.07..0.27) { strength ->
            val overshoots = ArrayList<Double>()
            var from = 0.0
            var goal = 0.0
            var most = 0.0
            watchMatches("arm-overshoot", strength) { run, _ ->
                val arm = checkNotNull(run.robot.arm)
                if (run.isEnabled) {
                    if (arm.setpoint != goal) {
                        if (abs(goal - from) > 0.4) overshoots += most
                        from = arm.measured
                        goal = arm.setpoint
                        most = 0.0
                    }
                    if (abs(goal - from) > 0.4) most = maxOf(most, (arm.measured - goal) / (goal - from))
                }
            }
            overshoots.sorted()[overshoots.size * 3 / 4]
        }
    }

    test("an elevator that is too weak stays far below high setpoints at 1, and hardly rises slower at 0.3 than its load allows") {
        atBoth("elevator-short", 0.25..0.8, 0.0..0.75) { strength ->
            var error = 0.0
            watchMatches("elevator-short", strength) { run, time ->
                val elevator = checkNotNull(run.robot.elevator)
                if (time > 2 && run.isEnabled) error = maxOf(error, (elevator.profile.position - elevator.position) / elevator.height)
            }
            error
        }
    }

    test("a drifting gyro is off by 1 ° per second at 1, by 0.3 ° at 0.3") {
        atBoth("gyro-drift", 0.9..1.1, 0.25..0.35) { strength ->
            var rate = 0.0
            watchMatches("gyro-drift", strength) { run, time ->
                if (time > 100) rate = Math.toDegrees(run.robot.gyro.yaw - run.robot.drive.heading) / (time + run.autoStart)
            }
            rate
        }
    }

    test("worn treads let the wheels slip often at 1, and more than sound ones at 0.3") {
        atBoth("wheel-slip", 0.05..0.9, 0.0005..0.3) { strength ->
            var slipping = 0
            var loops = 0
            watchMatches("wheel-slip", strength) { run, _ ->
                if (run.isEnabled) {
                    loops++
                    if (run.robot.drive.wheels.any { it.isSlipping }) slipping++
                }
            }
            slipping.toDouble() / loops
        }
    }

    test("a leak keeps the compressor running nearly all the time, a sound system seldom") {
        val shares = listOf("air-leak" to 1.0, "air-leak" to 0.3, "compressor-dead" to 1.0).map { (id, strength) ->
            var runs = 0
            var loops = 0
            watchMatches(id, strength) { run, _ ->
                if (run.isEnabled) {
                    loops++
                    if (checkNotNull(run.robot.air).current > 0) runs++
                }
            }
            runs.toDouble() / loops
        }
        shares[0].shouldBeBetween(0.95, 1.0, 0.0)
        shares[1].shouldBeBetween(0.6, 1.0, 0.0)
        shares[2].shouldBeBetween(0.0, 0.4, 0.0)
    }

    test("the robot is disabled for 20 s of a lost link at 1, for 6 s at 0.3; for 30 s and 9 s if the radio lost its power") {
        for ((id, seconds) in listOf("link-loss" to 20.0, "radio-power-loss" to 30.0)) {
            for (strength in listOf(1.0, 0.3)) {
                var off = 0
                watchMatches(id, strength) { run, _ -> if (!run.isLinked) off++ }
                withClue("$id at $strength") { (off * 0.02 / SEEDS).shouldBeBetween(seconds * strength * 0.97, seconds * strength * 1.03, 0.0) }
            }
        }
    }

    test("the voltage dips below 7.3 V when a radio loses its power") {
        var least = 20.0
        watchMatches("radio-power-loss", 1.0) { run, time -> if (time in 0.0..0.5) least = minOf(least, run.robot.battery.volts) }
        least.shouldBeBetween(4.8, 7.3, 0.0)
    }

    test("limits that are too high take the voltage down by more than a volt") {
        fun least(strength: Double): Double {
            var least = 20.0
            watchMatches("too-much-at-once", strength) { run, _ -> least = minOf(least, run.robot.battery.volts) }
            return least
        }
        (least(0.3) - least(1.0)).shouldBeBetween(0.5, 4.0, 0.0)
    }

    test("loops have the durations of their faults") {
        val worst = mapOf("garbage-collection" to 250.0..330.0, "blocking-call" to 60.0..110.0, "cpu-overload" to 25.0..90.0)
        for ((id, range) in worst) {
            var most = 0.0
            watchMatches(id, 1.0) { run, time -> if (time > 0) most = maxOf(most, run.robot.computer.userMillis) }
            withClue(id) { most.shouldBeBetween(range.start, range.endInclusive, 0.0) }
        }
    }
})
