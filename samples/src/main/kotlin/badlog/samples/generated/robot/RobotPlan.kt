package badlog.samples.generated.robot

import badlog.samples.generated.fault.Fault
import badlog.samples.generated.fault.Naming
import badlog.samples.generated.fault.Need

/**
 * A circumstance that makes a match without a fault look like one with a fault.
 *
 * @property title a description in words.
 */
internal enum class Hardship(val title: String) {
    /** Nothing special: the hits and the haste of any match. */
    NONE("an ordinary match"),
    COLLISIONS("many hits by other robots"),
    HARD_BRAKING("a driver who brakes hard and turns back at once"),
    AGED_BATTERY("an aged battery that is still acceptable: 26 mΩ, 12.55 V"),
    SLOW_SENSORS("status frames at a fifth of the usual rate"),
    PUSHED("pushing matches against other robots"),
    LONG_SPRINT("sprints over the whole field, without a pause"),
}

/**
 * The plan of a match: its robot, hardship and fault.
 *
 * @property seed the seed of all random numbers in the match.
 * @property parts its parts: [Need.SWERVE] or [Need.TANK], mechanisms, and [Need.VISION].
 * @property driveKind the motors of its drive.
 * @property steerKind the motors that steer its wheels and move its mechanisms.
 * @property hardship the circumstance that makes the match hard to judge.
 * @property fault the fault; null for none.
 * @property strength the strength of the fault, see [Fault.strength].
 */
internal data class RobotPlan(
    val seed: Long,
    val naming: Naming,
    val parts: Set<Need>,
    val driveKind: MotorKind,
    val steerKind: MotorKind,
    val hardship: Hardship,
    val fault: Fault?,
    val strength: Double,
) {
    companion object {
        private val MECHANISMS = listOf(Need.ELEVATOR, Need.ARM, Need.SHOOTER, Need.INTAKE, Need.PNEUMATICS, Need.VISION)

        fun of(seed: Long, naming: Naming, fault: Fault?, strength: Double, hardship: Hardship): RobotPlan {
            val chance = Chance(seed, "plan")
            val needs = fault?.needs.orEmpty()
            val prefersSwerve = chance.isIn(if (naming == Naming.BADLOG) 0.25 else 0.7)
            val isSwerve = Need.SWERVE in needs || (Need.TANK !in needs && prefersSwerve)
            val parts = linkedSetOf(if (isSwerve) Need.SWERVE else Need.TANK)
            for (part in MECHANISMS) if (chance.isIn(0.55) || part in needs) parts += part
            if (parts.size < 3) parts += listOf(Need.SHOOTER, Need.INTAKE)
            val kinds = when (naming) {
                Naming.PHOENIX -> listOf(MotorKind.KRAKEN_X60, MotorKind.FALCON_500)
                Naming.REV -> listOf(MotorKind.NEO)
                else -> listOf(MotorKind.KRAKEN_X60, MotorKind.FALCON_500, MotorKind.NEO)
            }
            val kind = chance.of(kinds)
            val isBrushed = chance.isIn(0.5) && !isSwerve && (naming == Naming.BADLOG || naming == Naming.WPILIB)
            return RobotPlan(seed, naming, parts, if (isBrushed) MotorKind.CIM else kind, kind, hardship, fault, strength)
        }
    }
}
