package badlog.samples.fault

import badlog.samples.ROBOT_VALUES
import badlog.samples.Run
import badlog.samples.TWO_PIECE_AUTONOMOUS
import badlog.samples.bag.BagLog
import badlog.samples.bag.NumberText
import badlog.samples.createElevatorTopics
import badlog.samples.createFieldTopics
import badlog.samples.createManipulatorTopics
import badlog.samples.createPowerTopics
import badlog.samples.createSystemTopics
import badlog.samples.cycle
import badlog.samples.match.DrivingStyle
import badlog.samples.match.Schedule
import badlog.samples.match.Task
import badlog.samples.matchValues
import badlog.samples.robot.Battery
import badlog.samples.robot.Drivetrain
import badlog.samples.robot.Mishap
import badlog.samples.robot.Mishaps
import badlog.samples.robot.Noise
import badlog.samples.robot.Robot

/**
 * A whole match, 15 s of autonomous and 135 s of teleop. Driver, battery, contacts with other robots and faults all follow from [seed].
 *
 * @property fault the fault; null for none.
 * @property isFaint whether the fault is so small or so late that the log may not show it.
 * @property second a second fault; null for none.
 * @param isSwerve whether the robot has four swerve modules; otherwise two gearboxes.
 */
class FaultyMatch(
    private val seed: Int,
    val fault: Fault?,
    val isFaint: Boolean = false,
    val second: Fault? = null,
    isSwerve: Boolean = false,
) {
    private val chassis = if (isSwerve) Chassis.SWERVE else Chassis.TANK

    /** The groups of motors that turn together, as in a team's `badlog-signals.toml`. */
    val signals: String get() = chassis.signals

    /** Returns the match's bag, with a row for every other loop of the robot. */
    fun bag(): ByteArray {
        val noise = Noise(seed * SPREAD)
        val plan = healthyPlan(noise)
        val style = DrivingStyle(fastest = 0.72 + 0.22 * noise.unit(), ramp = 1.7 + 1.3 * noise.unit())
        fault?.plant(plan, noise, isFaint)
        second?.plant(plan, Noise(seed * SPREAD + 2), isFaint = false)
        plan.crash?.let { plan.mishaps += it }
        val mishaps = Mishaps(plan.mishaps)
        val robot = Robot(
            seed = seed.toLong(),
            battery = plan.battery,
            drivetrain = Drivetrain(x = 1.55, y = 3.0, heading = StrictMath.PI),
            pressure = 95 + 25 * noise.unit(),
            mishaps = mishaps,
        )
        val run = Run(seed.toLong(), robot, Schedule.match(secondsAfter = 2.0), plan.orders, mishaps, style)
        return logOf(run, mishaps, plan)
    }

    private fun logOf(run: Run, mishaps: Mishaps, plan: MatchPlan): ByteArray {
        val radio = Radio(mishaps, Noise(seed * SPREAD + 1))
        val instruments = Instruments(Noise(seed * SPREAD + 3))
        val crash = plan.crash
        val begins = if (crash != null && !plan.hasLogBefore) crash.at + crash.seconds else 0.0
        val ends = if (crash != null && plan.hasLogBefore) crash.at else Double.MAX_VALUE
        val values = matchValues("2024-03-16T12:00:00", "$seed", "Blue", "2", "B5, 2023") + ROBOT_VALUES
        val log = BagLog(NumberText.SENSOR_DECIMALS, values, instruments::measuring)
        var slowest = 0.0
        log.number("Time", "s", 6, "hide", "delta", "xaxis") { run.time - begins }
        log.number("Match Time", "s", 0) { run.matchSecondsLeft.toDouble() }
        log.createSystemTopics(run.robot, run::nextEvent) { slowest }
        log.createPowerTopics(run.robot, withChannels = true)
        val measureChassis = chassis.createTopics(log, run.robot, mishaps, Noise(seed * SPREAD + 4))
        log.createElevatorTopics(run.robot)
        log.createManipulatorTopics(run.robot)
        log.createFieldTopics(run.robot)
        log.createFaultTopics(run.robot, radio)
        log.finishInitialization()
        var loops = 0
        run.loop {
            radio.pass(run.time)
            measureChassis(run.time)
            slowest = maxOf(slowest, run.robot.roboRio.loopMillis)
            if (run.time >= begins && run.time <= ends && loops++ % LOOPS_PER_ROW == 0) {
                instruments.nextRow(mishaps.canIsCut(run.time))
                log.log()
                slowest = 0.0
            }
        }
        return log.bytes()
    }

    private fun healthyPlan(noise: Noise): MatchPlan {
        val battery = Battery(
            ohms = 0.0110 + 0.004 * noise.unit(),
            slowOhms = 0.003 + 0.002 * noise.unit(),
            ampHours = 15 + 4 * noise.unit(),
            charge = 0.93 + 0.07 * noise.unit(),
        )
        val orders = TWO_PIECE_AUTONOMOUS.toMutableList()
        var at = 19.3 + noise.unit()
        while (at < 138) {
            val load = Task.DriveTo(12.6 + 1.2 * noise.unit(), 5.0 + 1.2 * noise.unit())
            orders += cycle(at, load)
            at += 17.0 + 0.8 * noise.unit()
        }
        val plan = MatchPlan(chassis, battery, orders, ArrayList())
        // Any match has short contacts with other robots and occasional late loops.
        repeat(noise.upTo(3)) { plan.insert(noise.timeIn(25.0, 130.0), Task.Push, 0.15 + 0.25 * noise.unit()) }
        repeat(noise.upTo(3)) { plan.mishaps += Mishap.Stall(noise.timeIn(4.0, 150.0), 0.004 + 0.02 * noise.unit(), "") }
        return plan
    }

    companion object {
        private const val LOOPS_PER_ROW = 2

        // The distance between seeds, so that neighboring seeds do not share random numbers.
        private const val SPREAD = 7919L

        /**
         * Returns the match of [seed]. Seeds go through all faults and none, with either chassis. One fault in five is faint, and one in
         * five has a second fault.
         */
        fun of(seed: Int): FaultyMatch {
            val faults = Fault.entries + null
            val fault = faults[seed % faults.size]
            val turn = seed / faults.size
            val others = Fault.entries - listOfNotNull(fault).toSet()
            val second = others[Noise(seed * SPREAD + 5).upTo(others.size)].takeIf { fault != null && turn % 5 == 3 }
            return FaultyMatch(seed, fault, isFaint = turn % 5 == 0, second, isSwerve = turn % 2 == 1)
        }
    }
}
