package badlog.samples.robot

/** What goes wrong in a recording, and when, in seconds. What follows from it is up to the robot. */
class Mishaps(private val all: List<Mishap> = emptyList()) {
    /** How much longer than planned the loop that begins at [time] takes. */
    fun stallSeconds(time: Double): Double =
        all.filterIsInstance<Mishap.Stall>().filter { time >= it.at && time < it.at + 0.02 }.sumOf { it.seconds }

    fun canIsSilent(time: Double): Boolean = all.any { it is Mishap.CanSilence && time >= it.at && time < it.at + it.seconds }

    fun isHitAt(time: Double, seconds: Double): Boolean = all.any { it is Mishap.Hit && time >= it.at && time - seconds < it.at }

    /** Whether nothing is heard on the whole bus. */
    fun canIsCut(time: Double): Boolean = all.any { it is Mishap.CanCut && time >= it.at && time < it.at + it.seconds }

    fun programRuns(time: Double): Boolean = all.none { it is Mishap.ProgramCrash && time >= it.at && time < it.at + it.seconds }

    fun hasLink(time: Double): Boolean = all.none { it is Mishap.RadioReboot && time >= it.at && time < it.at + it.seconds }

    fun elevatorIsSeized(time: Double): Boolean = all.any { it is Mishap.SeizedElevator && time >= it.at }

    /** The sides of the drivetrain on which one of two motors is unplugged. */
    fun unpluggedSides(time: Double): List<Side> = all.filter { time >= it.at }.mapNotNull { (it as? Mishap.UnpluggedMotor)?.side }

    fun seizedGearbox(time: Double): SeizedGearbox? =
        all.firstNotNullOfOrNull { stuck -> (stuck as? Mishap.SeizedDrive)?.takeIf { time >= it.at }?.gearbox }

    fun elevatorIsHalf(time: Double): Boolean = all.any { it is Mishap.UnpluggedElevatorMotor && time >= it.at }

    /** The sides of the drivetrain whose encoder cable is pulled. */
    fun blindSides(time: Double): List<Side> = all.filter { time >= it.at }.mapNotNull { (it as? Mishap.PulledEncoder)?.side }

    fun contactOhms(time: Double): Double =
        all.firstNotNullOfOrNull { lead -> (lead as? Mishap.LooseLead)?.takeIf { time >= it.at && time < it.at + it.seconds } }?.ohms ?: 0.0

    /** What the robot's program reports of what happened from [from] until [until]. */
    fun reportsBetween(from: Double, until: Double): List<String> = all.filter { it.saidAt >= from && it.saidAt < until }.map { it.report }
}

/**
 * @property saidAt when the robot's program notices.
 * @property report what it then writes to the event log; may be empty.
 */
sealed class Mishap(val at: Double, val saidAt: Double, val report: String) {
    class Stall(at: Double, val seconds: Double, report: String) : Mishap(at, at + seconds, report)

    /** A mechanism whose motor controller is not heard on the bus. */
    class CanSilence(at: Double, val seconds: Double, report: String) : Mishap(at, at + 0.1, report)

    class Hit(at: Double, report: String) : Mishap(at, at + 0.3, report)

    class LooseLead(at: Double, val seconds: Double, val ohms: Double = 0.035) : Mishap(at, at, "")

    /** No motor controller is heard, and none receives anything: all values stay as they were, and motors stop. */
    class CanCut(at: Double, val seconds: Double) : Mishap(at, at, "")

    /** The program ends, and is started again after [seconds]; until then the robot is disabled. */
    class ProgramCrash(at: Double, val seconds: Double, report: String) : Mishap(at, at - 0.05, report)

    class RadioReboot(at: Double, val seconds: Double) : Mishap(at, at, "")

    class SeizedElevator(at: Double) : Mishap(at, at, "")

    class SeizedDrive(at: Double, val gearbox: SeizedGearbox) : Mishap(at, at, "")

    class UnpluggedElevatorMotor(at: Double) : Mishap(at, at, "")

    class UnpluggedMotor(at: Double, val side: Side) : Mishap(at, at, "")

    class PulledEncoder(at: Double, val side: Side) : Mishap(at, at, "")
}
