package badlog.samples.robot

/** The mishaps in a recording, with their times in s. Their consequences follow from the simulated robot. */
class Mishaps(private val all: List<Mishap> = emptyList()) {
    /** Returns the extra duration of the loop that begins at [time], in s. */
    fun stallSeconds(time: Double): Double =
        all.filterIsInstance<Mishap.Stall>().filter { time >= it.at && time < it.at + 0.02 }.sumOf { it.seconds }

    fun canIsSilent(time: Double): Boolean = all.any { it is Mishap.CanSilence && time >= it.at && time < it.at + it.seconds }

    fun isHitAt(time: Double, seconds: Double): Boolean = all.any { it is Mishap.Hit && time >= it.at && time - seconds < it.at }

    /** Returns whether the whole bus is silent. */
    fun canIsCut(time: Double): Boolean = all.any { it is Mishap.CanCut && time >= it.at && time < it.at + it.seconds }

    fun programRuns(time: Double): Boolean = all.none { it is Mishap.ProgramCrash && time >= it.at && time < it.at + it.seconds }

    fun hasLink(time: Double): Boolean = all.none { it is Mishap.RadioReboot && time >= it.at && time < it.at + it.seconds }

    fun elevatorIsSeized(time: Double): Boolean = all.any { it is Mishap.SeizedElevator && time >= it.at }

    /** Returns the sides of the drivetrain with one of two motors unplugged. */
    fun unpluggedSides(time: Double): List<Side> = all.filter { time >= it.at }.mapNotNull { (it as? Mishap.UnpluggedMotor)?.side }

    fun seizedGearbox(time: Double): SeizedGearbox? =
        all.firstNotNullOfOrNull { stuck -> (stuck as? Mishap.SeizedDrive)?.takeIf { time >= it.at }?.gearbox }

    fun elevatorIsHalf(time: Double): Boolean = all.any { it is Mishap.UnpluggedElevatorMotor && time >= it.at }

    /** Returns the sides of the drivetrain with a pulled encoder cable. */
    fun blindSides(time: Double): List<Side> = all.filter { time >= it.at }.mapNotNull { (it as? Mishap.PulledEncoder)?.side }

    fun contactOhms(time: Double): Double =
        all.firstNotNullOfOrNull { lead -> (lead as? Mishap.LooseLead)?.takeIf { time >= it.at && time < it.at + it.seconds } }?.ohms ?: 0.0

    /** Returns the program's reports of mishaps noticed between [from] and [until]. */
    fun reportsBetween(from: Double, until: Double): List<String> =
        all.filter { it.reportedAt >= from && it.reportedAt < until }.map { it.report }
}

/**
 * A mishap that starts at second [at].
 *
 * @property reportedAt the time at which the robot's program reports it, in s.
 * @property report the program's text in the event log; may be empty.
 */
sealed class Mishap(val at: Double, val reportedAt: Double, val report: String) {
    class Stall(at: Double, val seconds: Double, report: String) : Mishap(at, at + seconds, report)

    /** A mechanism's motor controller is silent on the bus. */
    class CanSilence(at: Double, val seconds: Double, report: String) : Mishap(at, at + 0.1, report)

    class Hit(at: Double, report: String) : Mishap(at, at + 0.3, report)

    class LooseLead(at: Double, val seconds: Double, val ohms: Double = 0.035) : Mishap(at, at, "")

    /** All motor controllers are cut off from the bus: their values stay unchanged, and motors stop. */
    class CanCut(at: Double, val seconds: Double) : Mishap(at, at, "")

    /** The program ends and restarts after [seconds]; until then the robot is disabled. */
    class ProgramCrash(at: Double, val seconds: Double, report: String) : Mishap(at, at - 0.05, report)

    class RadioReboot(at: Double, val seconds: Double) : Mishap(at, at, "")

    class SeizedElevator(at: Double) : Mishap(at, at, "")

    class SeizedDrive(at: Double, val gearbox: SeizedGearbox) : Mishap(at, at, "")

    class UnpluggedElevatorMotor(at: Double) : Mishap(at, at, "")

    class UnpluggedMotor(at: Double, val side: Side) : Mishap(at, at, "")

    class PulledEncoder(at: Double, val side: Side) : Mishap(at, at, "")
}
