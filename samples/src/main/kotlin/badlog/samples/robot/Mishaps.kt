package badlog.samples.robot

/** What goes wrong in a recording, and when, in seconds. What follows from it is up to the robot. */
class Mishaps(private val all: List<Mishap> = emptyList()) {
    /** How much longer than planned the loop that begins at [time] takes. */
    fun stallSeconds(time: Double): Double =
        all.filterIsInstance<Mishap.Stall>().filter { time >= it.at && time < it.at + 0.02 }.sumOf { it.seconds }

    fun canIsSilent(time: Double): Boolean = all.any { it is Mishap.CanSilence && time >= it.at && time < it.at + it.seconds }

    fun isHitAt(time: Double, seconds: Double): Boolean = all.any { it is Mishap.Hit && time >= it.at && time - seconds < it.at }

    fun contactOhms(time: Double): Double =
        if (all.any { it is Mishap.LooseLead && time >= it.at && time < it.at + it.seconds }) 0.035 else 0.0

    /** What the robot's program says of what happened between [from] and [until]. */
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

    class LooseLead(at: Double, val seconds: Double) : Mishap(at, at, "")
}
