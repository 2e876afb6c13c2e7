package badlog.samples.generated

import badlog.core.recording.Value
import badlog.samples.generated.fault.FAULTS
import badlog.samples.generated.fault.Fault
import badlog.samples.generated.fault.Naming
import badlog.samples.generated.fault.STRENGTHS
import badlog.samples.generated.fault.Visibility
import badlog.samples.generated.log.BagRecorder
import badlog.samples.generated.log.LogOrigin
import badlog.samples.generated.log.LoggedTopic
import badlog.samples.generated.log.Recorder
import badlog.samples.generated.log.WpilogRecorder
import badlog.samples.generated.log.advantageKitTopics
import badlog.samples.generated.log.badlogTopics
import badlog.samples.generated.log.phoenixTopics
import badlog.samples.generated.log.revTopics
import badlog.samples.generated.log.robotTopicsOf2027
import badlog.samples.generated.log.stationTopicsOf2027
import badlog.samples.generated.log.wpilibTopics
import badlog.samples.generated.robot.Hardship
import badlog.samples.generated.robot.MatchObserver
import badlog.samples.generated.robot.MatchRun
import badlog.samples.generated.robot.Planting
import badlog.samples.generated.robot.RobotPlan
import java.util.Locale

/**
 * Generates logs of whole matches of simulated robots, with or without a planted fault. The same seed gives the same bytes.
 *
 * @param seed the seed of all random numbers.
 */
class MatchGenerator(private val seed: Long) {
    /**
     * Returns an endless, lazy sequence of matches: each fault at each strength in each naming in turn, and a match without a fault after
     * every second one.
     */
    fun matches(namings: List<Naming> = Naming.entries): Sequence<GeneratedMatch> = planned(namings).map { it.run() }

    /** Returns the same matches before their robots drive. */
    internal fun planned(namings: List<Naming> = Naming.entries): Sequence<PlannedMatch> = sequence {
        var healthy = 0
        for (round in 0..Int.MAX_VALUE) {
            var faulty = 0
            // Different namings and strengths follow each other, so that a short sequence is varied, too.
            for (turn in 0 until namings.size * STRENGTHS.size) {
                for ((index, fault) in FAULTS.withIndex()) {
                    val naming = namings[(turn + index) % namings.size]
                    val strength = STRENGTHS[(turn / namings.size + index) % STRENGTHS.size]
                    yield(plannedFaulty(naming, fault, strength, round))
                    if (++faulty % 2 == 0) yield(plannedHealthy(namings[healthy % namings.size], healthy++))
                }
            }
        }
    }

    /** Returns match [number] of a robot with [fault]; other numbers have other robots, drivers and times. */
    fun faulty(naming: Naming, fault: Fault, strength: Double, number: Int = 0): GeneratedMatch =
        plannedFaulty(naming, fault, strength, number).run()

    /** Returns match [number] without a fault. Every third one is hard: it has something that looks like a fault. */
    fun healthy(naming: Naming, number: Int): GeneratedMatch = plannedHealthy(naming, number).run()

    private fun plannedFaulty(naming: Naming, fault: Fault, strength: Double, number: Int): PlannedMatch {
        require(strength in 0.1..1.0) { "The strength of “$fault” is $strength; use 0.3 to 1." }
        val own = mixed(naming.ordinal + 16L * number + 1_000_003L * fault.id.hashCode())
        val percent = (strength * 100).toInt()
        return PlannedMatch("${naming.id}-${fault.id}-$percent-$number", RobotPlan.of(own, naming, fault, strength, Hardship.NONE))
    }

    private fun plannedHealthy(naming: Naming, number: Int): PlannedMatch {
        val own = mixed(naming.ordinal + 16L * number + 7)
        val hard = Hardship.entries.drop(1)
        val hardship = if (number % 3 == 2) hard[number / 3 % hard.size] else Hardship.NONE
        return PlannedMatch("${naming.id}-healthy-$number", RobotPlan.of(own, naming, null, 0.0, hardship))
    }

    private fun mixed(number: Long): Long = (seed * -0x61c8864680b583ebL + number) * -0x4b47d0c5a1a2f3b5L xor number.rotateLeft(32)

    companion object {
        /**
         * Returns [match] without its fault: with the same robot, driver, hits and noise. Topics at the same times differ only because of
         * the fault.
         */
        fun withoutFault(match: GeneratedMatch): GeneratedMatch {
            val fault = requireNotNull(match.fault) { "“${match.name}” has no fault; give a match that has one." }
            val plan = RobotPlan.of(match.seed, match.naming, fault, match.strength, Hardship.NONE)
            return generated("${match.name}-without", plan.copy(fault = null, strength = 0.0))
        }

        /** Returns [match], a log of WPILib's logger, as a 2027 robot would log it: with the same samples in the 2027 format. */
        fun asIn2027(match: GeneratedMatch): GeneratedMatch = generated("${match.name}-2027", planOf(match), LogOrigin.ROBOT_OF_2027)

        /** Returns the log of the 2027 Driver Station for [match], a log of WPILib's logger. */
        fun stationIn2027(match: GeneratedMatch): GeneratedMatch =
            generated("FIRST_DS_${match.name}", planOf(match), LogOrigin.STATION_OF_2027)

        private fun planOf(match: GeneratedMatch): RobotPlan {
            require(match.naming == Naming.WPILIB) {
                "The topics of “${match.name}” are named as ${match.naming.id} does; pass a match of ${Naming.WPILIB.id}."
            }
            val hardship = Hardship.entries.first { it.title == match.hardship }
            return RobotPlan.of(match.seed, match.naming, match.fault, match.strength, hardship)
        }
    }
}

/** A match before its robot drives. */
internal class PlannedMatch(val name: String, val plan: RobotPlan) {
    /** Lets the robot drive, and returns the match with its log. */
    fun run(): GeneratedMatch = generated(name, plan)
}

private fun generated(name: String, plan: RobotPlan, origin: LogOrigin = LogOrigin.AS_NAMED): GeneratedMatch {
    val run = MatchRun(plan)
    val topics = when (origin) {
        LogOrigin.AS_NAMED -> topicsOf(run)
        LogOrigin.ROBOT_OF_2027 -> robotTopicsOf2027(run)
        LogOrigin.STATION_OF_2027 -> stationTopicsOf2027(run)
    }
    // A WPILOG's clock starts when the robot is switched on.
    val boot = origin.clockSeconds + if (plan.naming.isBag) 0.0 else 20 + Math.floorMod(plan.seed, 1000L) / 10.0
    val recorder = recorderOf(run, topics, boot)
    run.run(object : MatchObserver {
        override fun looped(time: Double) = recorder.loop(time)

        override fun framed(time: Double) = recorder.frame(time)
    })
    return GeneratedMatch(
        name = name,
        seed = plan.seed,
        naming = plan.naming,
        fault = plan.fault,
        strength = plan.strength,
        hardship = plan.hardship.title,
        isHard = plan.hardship != Hardship.NONE,
        start = run.planting?.let { boot + if (it.fault.start.endInclusive == 0.0) 0.0 else run.autoStart + it.start },
        part = run.planting?.part.orEmpty(),
        evidence = run.planting?.takeIf {
            it.fault.sightIn(plan.naming).visibility != Visibility.NOTHING
        }?.let { evidenceOf(it, topics) }.orEmpty(),
        bytes = recorder.bytes(),
    )
}

private fun topicsOf(run: MatchRun): List<LoggedTopic> = when (run.plan.naming) {
    Naming.ADVANTAGEKIT -> advantageKitTopics(run)
    Naming.WPILIB -> wpilibTopics(run)
    Naming.PHOENIX -> phoenixTopics(run)
    Naming.REV -> revTopics(run)
    Naming.BADLOG -> badlogTopics(run)
}

private fun recorderOf(run: MatchRun, topics: List<LoggedTopic>, boot: Double): Recorder = when (run.plan.naming) {
    Naming.BADLOG -> BagRecorder(
        topics,
        listOf(Value("Match", "Q" + Math.floorMod(run.plan.seed, 79L).plus(1)), Value("Robot", "practice")),
    )

    Naming.ADVANTAGEKIT -> WpilogRecorder(topics, boot, "AdvantageKit", keepsRepeats = false)

    Naming.WPILIB -> WpilogRecorder(topics, boot, "", keepsRepeats = false)

    // Devices send their values repeatedly, and their loggers keep all of them.
    Naming.PHOENIX, Naming.REV -> WpilogRecorder(topics, boot, "", keepsRepeats = true)
}

private fun evidenceOf(planting: Planting, topics: List<LoggedTopic>): List<String> = topics.filter { topic ->
    val isFaultyPart = topic.part.isEmpty() || planting.part.isEmpty() || topic.part == planting.part
    topic.signal in planting.fault.shownBy && isFaultyPart
}.map { it.name }

/** Returns [seconds] with three decimals. */
internal fun decimals(seconds: Double): String = "%.3f".format(Locale.ROOT, seconds)
