package badlog.samples.generated

import badlog.samples.generated.fault.FAULTS
import badlog.samples.generated.fault.Naming
import badlog.samples.generated.robot.Hardship
import badlog.samples.generated.robot.MatchObserver
import badlog.samples.generated.robot.MatchRun
import badlog.samples.generated.robot.MotorKind
import badlog.samples.generated.robot.RobotPlan
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.comparables.shouldBeLessThanOrEqualTo
import io.kotest.matchers.doubles.shouldBeBetween
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import kotlin.math.abs
import kotlin.math.hypot

private fun watched(plan: RobotPlan, watch: (MatchRun, Double) -> Unit): MatchRun = MatchRun(plan).apply {
    run(object : MatchObserver {
        override fun looped(time: Double) = watch(this@apply, time)

        override fun framed(time: Double) = Unit
    })
}

private fun plans(hardship: Hardship) = Naming.entries.flatMap { naming -> List(4) { RobotPlan.of(it * 7919L + 1, naming, null, 0.0, hardship) } }

@Tags("InCheck")
class PhysicsSpec : FunSpec({
    for (hardship in Hardship.entries) {
        test("a robot without a fault stays within the limits of batteries, motors and fields: ${hardship.title}") {
            for (plan in plans(hardship)) {
                withClue("$plan") {
                    var brownouts = 0
                    watched(plan) { run, _ ->
                        val robot = run.robot
                        robot.battery.volts.shouldBeBetween(6.0, 13.5, 0.0)
                        robot.drive.x.shouldBeBetween(0.0, 16.5, 0.0)
                        robot.drive.y.shouldBeBetween(0.0, 8.2, 0.0)
                        hypot(robot.drive.vx, robot.drive.vy) shouldBeLessThan 6.5
                        for (device in robot.devices) {
                            val motor = device.motor
                            abs(motor.current) shouldBeLessThanOrEqualTo motor.statorLimit + 0.6
                            motor.supply / motor.count shouldBeLessThanOrEqualTo minOf(motor.supplyLimit, motor.statorLimit) + 0.6
                            abs(motor.speed) shouldBeLessThan motor.kind.freeRpm * Math.PI / 30 * 1.6
                            motor.temperature.shouldBeBetween(20.0, 90.0, 0.0)
                        }
                        if (run.isBrownedOut) brownouts++
                    }
                    brownouts shouldBe 0
                }
            }
        }
    }

    test("the battery's energy equals the consumption of motors, compressor and computers") {
        for (plan in plans(Hardship.NONE)) {
            var taken = 0.0
            val run = MatchRun(plan)
            val robot = run.robot
            var last = 0.0
            run.run(object : MatchObserver {
                override fun looped(time: Double) = Unit

                override fun framed(time: Double) {
                    val amperes = robot.standby + robot.devices.sumOf { it.motor.supply } + (robot.air?.current ?: 0.0)
                    taken += amperes * robot.battery.volts * (time - last)
                    last = time
                }
            })
            abs(taken - robot.battery.energy) / robot.battery.energy shouldBeLessThan 0.05
            // Only a small share of the energy is lost as heat.
            (robot.battery.heat / robot.battery.energy).shouldBeBetween(0.01, 0.25, 0.0)
            // A match takes one to two of a battery's 18 Ah.
            (robot.battery.energy / 12 / 3600).shouldBeBetween(0.4, 3.0, 0.0)
        }
    }

    test("motors have the torque and speed of their data sheets") {
        val sheet = mapOf(MotorKind.KRAKEN_X60 to 0.0328, MotorKind.FALCON_500 to 0.0467, MotorKind.NEO to 0.1143, MotorKind.CIM to 0.0902)
        for ((kind, ohms) in sheet) abs(kind.resistance - ohms) shouldBeLessThan 0.0005
    }

    test("mechanisms without a fault follow their setpoints") {
        for (plan in plans(Hardship.NONE)) {
            withClue("$plan") {
                var settled = 0
                var missed = 0
                watched(plan) { run, _ ->
                    if (run.isEnabled) {
                        run.robot.elevator?.let {
                            settled++
                            if (abs(it.measured - it.profile.position) > 0.12) missed++
                        }
                        run.robot.arm?.let {
                            settled++
                            if (abs(it.measured - it.setpoint) > 0.3) missed++
                        }
                    }
                }
                missed.toDouble() shouldBeLessThanOrEqualTo settled * 0.01
            }
        }
    }

    test("an old battery has the resistance for its strength") {
        val fault = FAULTS.first { it.id == "old-battery" }
        for (strength in listOf(1.0, 0.3)) {
            var count = 0
            val sums = DoubleArray(4)
            watched(RobotPlan.of(5, Naming.BADLOG, fault, strength, Hardship.NONE)) { run, _ ->
                val amperes = run.robot.battery.current
                val volts = run.robot.battery.volts
                if (run.isEnabled && !run.isBrownedOut) {
                    count++
                    sums[0] += amperes
                    sums[1] += volts
                    sums[2] += amperes * amperes
                    sums[3] += amperes * volts
                }
            }
            val slope = (sums[3] - sums[0] * sums[1] / count) / (sums[2] - sums[0] * sums[0] / count)
            (-slope).shouldBeBetween(0.013 + 0.05 * strength, 0.027 + 0.05 * strength, 0.0)
        }
    }
})
