package badlog.samples.fault

import badlog.samples.match.Order
import badlog.samples.match.Task
import badlog.samples.robot.Battery
import badlog.samples.robot.Mishap
import badlog.samples.robot.Noise
import badlog.samples.robot.SeizedGearbox
import badlog.samples.robot.Side
import badlog.samples.robot.Superstructure

/**
 * A fault in a simulated match. Only the cause is planted: voltages, currents and outputs follow from the simulated robot.
 *
 * @property title its name for people.
 */
enum class Fault(val title: String) {
    WALL("pushing against a wall") {
        override fun plant(plan: MatchPlan, noise: Noise, isFaint: Boolean) {
            val at = noise.timeIn(24.0, 120.0)
            val throttle = if (isFaint) 0.35 + 0.1 * noise.unit() else 0.65 + 0.35 * noise.unit()
            val seconds = if (isFaint) 0.6 + 0.2 * noise.unit() else 1.0 + 3.6 * noise.unit()
            plan.insert(at, Task.PushWall(throttle), seconds)
        }
    },
    LOOSE_LEAD("loose battery lead") {
        override fun plant(plan: MatchPlan, noise: Noise, isFaint: Boolean) {
            var at = noise.timeIn(20.0, 100.0)
            repeat(if (isFaint) 2 else 5 + noise.upTo(11)) {
                val ohms = if (isFaint) 0.015 + 0.01 * noise.unit() else 0.035 + 0.1 * noise.unit()
                plan.mishaps += Mishap.LooseLead(at, 0.05 + 0.2 * noise.unit(), ohms)
                at += 0.4 + 3 * noise.unit()
            }
        }
    },
    TIRED_BATTERY("tired battery") {
        override fun plant(plan: MatchPlan, noise: Noise, isFaint: Boolean) {
            plan.battery = if (isFaint) {
                Battery(0.018 + 0.002 * noise.unit(), 0.006, 13.0, 0.85)
            } else {
                Battery(0.024 + 0.013 * noise.unit(), 0.008 + 0.008 * noise.unit(), 9 + 3 * noise.unit(), 0.55 + 0.3 * noise.unit())
            }
        }
    },
    SEIZED_MOTOR("seized motor") {
        // A faint one seizes the elevator while it only holds still, which may go unnoticed.
        override fun plant(plan: MatchPlan, noise: Noise, isFaint: Boolean) {
            plan.mishaps += Mishap.SeizedElevator(if (isFaint) plan.lastRaise + 1.4 else noise.timeIn(20.0, 118.0))
        }
    },
    SEIZED_DRIVE("seized drive gearbox") {
        override fun plant(plan: MatchPlan, noise: Noise, isFaint: Boolean) {
            val at = if (isFaint) noise.timeIn(152.0, 153.5) else noise.timeIn(20.0, 115.0)
            plan.mishaps += Mishap.SeizedDrive(at, SeizedGearbox(noise.side(), plan.chassis.motorsPerGearbox))
        }
    },
    UNPLUGGED_MOTOR("one of two linked motors unplugged") {
        override fun plant(plan: MatchPlan, noise: Noise, isFaint: Boolean) {
            val at = if (isFaint) noise.timeIn(150.0, 152.0) else noise.timeIn(0.0, 110.0)
            val side = noise.side()
            plan.mishaps += if (plan.chassis == Chassis.TANK) Mishap.UnpluggedMotor(at, side) else Mishap.UnpluggedElevatorMotor(at)
        }
    },
    PULLED_ENCODER("encoder cable pulled") {
        override fun plant(plan: MatchPlan, noise: Noise, isFaint: Boolean) {
            val at = if (isFaint) noise.timeIn(148.0, 151.0) else noise.timeIn(5.0, 110.0)
            plan.mishaps += Mishap.PulledEncoder(at, noise.side())
        }
    },
    CAN_CUT("CAN interrupted") {
        override fun plant(plan: MatchPlan, noise: Noise, isFaint: Boolean) {
            var at = noise.timeIn(20.0, 100.0)
            repeat(if (isFaint) 1 else 1 + noise.upTo(4)) {
                plan.mishaps += Mishap.CanCut(at, if (isFaint) 0.05 + 0.05 * noise.unit() else 0.2 + 2 * noise.unit())
                at += 4 + 8 * noise.unit()
            }
        }
    },
    RADIO_REBOOT("radio reboot") {
        override fun plant(plan: MatchPlan, noise: Noise, isFaint: Boolean) {
            val seconds = if (isFaint) 0.1 + 0.2 * noise.unit() else 22 + 20 * noise.unit()
            plan.mishaps += Mishap.RadioReboot(noise.timeIn(22.0, 105.0), seconds)
        }
    },
    SLOW_VISION("loop blocked by vision") {
        override fun plant(plan: MatchPlan, noise: Noise, isFaint: Boolean) {
            var at = noise.timeIn(20.0, 100.0)
            val isLogged = noise.unit() < 0.3
            repeat(if (isFaint) 1 else 2 + noise.upTo(6)) {
                val seconds = if (isFaint) 0.025 + 0.015 * noise.unit() else 0.1 + 0.4 * noise.unit()
                val report = if (isLogged) "WARN: loop overrun, \"Vision.update\" took ${(seconds * 1000).toInt()} ms" else ""
                plan.mishaps += Mishap.Stall(at, seconds, report)
                at += 1 + 5 * noise.unit()
            }
        }
    },
    RESTART("code crash and restart") {
        override fun plant(plan: MatchPlan, noise: Noise, isFaint: Boolean) {
            val at = if (isFaint) noise.timeIn(143.0, 145.0) else noise.timeIn(22.0, 125.0)
            plan.crash = Mishap.ProgramCrash(at, 5 + 6 * noise.unit(), if (noise.unit() < 0.6) EXCEPTION else "")
            plan.hasLogBefore = noise.unit() < 0.5
        }
    }, ;

    /** Plants the fault in [plan]; a faint one may leave nothing to find in the log. */
    internal abstract fun plant(plan: MatchPlan, noise: Noise, isFaint: Boolean)
}

/** The plan of a simulated match before it begins. */
internal class MatchPlan(val chassis: Chassis, var battery: Battery, val orders: MutableList<Order>, val mishaps: MutableList<Mishap>) {
    var crash: Mishap.ProgramCrash? = null

    /** Whether the log is the one from before the program's crash; otherwise the one after it. */
    var hasLogBefore = false

    /** The time when the elevator is raised for the last time. */
    val lastRaise get() = orders.last { it.state == Superstructure.RAISING }.at

    /** Inserts [task] at [at] for [seconds]; then the robot backs off and resumes its earlier task. */
    fun insert(at: Double, task: Task, seconds: Double) {
        val before = orders.last { it.at <= at }
        orders.removeAll { it.at > at && it.at <= at + seconds + BACK_OFF }
        orders += Order(at, task, before.state)
        orders += Order(at + seconds, Task.BackOff, before.state)
        orders += Order(at + seconds + BACK_OFF, before.task, before.state)
        orders.sortBy { it.at }
    }
}

internal fun Noise.timeIn(from: Double, until: Double): Double = from + unit() * (until - from)

internal fun Noise.upTo(count: Int): Int = (unit() * count).toInt()

private fun Noise.side() = if (unit() < 0.5) Side.LEFT else Side.RIGHT

private const val EXCEPTION = "ERROR: Unhandled exception: java.lang.NullPointerException: Cannot invoke \"Pose2d.getX()\""

private const val BACK_OFF = 0.8
