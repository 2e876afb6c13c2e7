package badlog.rules.number

/**
 * A signal with numbers to compare.
 *
 * @property least the smallest difference that counts, in the unit of the signal.
 * @property isRatio whether a difference is relative to the usual value, rather than absolute as for voltages.
 * @property isWorseBelow whether less than usual, rather than more, is worth a look.
 * @property isOfMotor whether it belongs to one motor: a motor that takes less than usual while the robot drives is also suspicious.
 */
internal class ComparedSignal(
    val signal: String,
    val measures: List<Measure>,
    val least: Double,
    val isRatio: Boolean = true,
    val isWorseBelow: Boolean = false,
    val isOfMotor: Boolean = false,
) {
    companion object {
        // Not in autonomous: what takes current there depends on which of several routines the team chose.
        private val CURRENT = listOf(Measure.TELEOP, Measure.DRIVING, Measure.ENABLED)

        val ALL = listOf(
            ComparedSignal("battery", listOf(Measure.LOWEST), least = 0.8, isRatio = false, isWorseBelow = true),
            ComparedSignal("total current", CURRENT, least = 10.0),
            ComparedSignal("loop time", listOf(Measure.PERCENTILE95), least = 3.0),
            ComparedSignal("CAN load", listOf(Measure.ENABLED), least = 8.0),
            ComparedSignal("CPU load", listOf(Measure.ENABLED), least = 10.0),
            ComparedSignal("CPU temperature", listOf(Measure.HIGHEST), least = 10.0, isRatio = false),
            ComparedSignal("trip time", listOf(Measure.ENABLED), least = 5.0),
            ComparedSignal("packet loss", listOf(Measure.ENABLED), least = 1.0),
            ComparedSignal("vision latency", listOf(Measure.ENABLED), least = 10.0),
            ComparedSignal("channel current", CURRENT, least = 3.0, isOfMotor = true),
            ComparedSignal("motor current", CURRENT, least = 3.0, isOfMotor = true),
            ComparedSignal("stator current", CURRENT, least = 5.0, isOfMotor = true),
            ComparedSignal("motor temperature", listOf(Measure.HIGHEST), least = 12.0, isRatio = false),
            ComparedSignal(NumberKey.RESISTANCE, listOf(Measure.RESISTANCE), least = 3.0),
        )

        private val BY_NAME = ALL.associateBy { it.signal }

        fun of(signal: String): ComparedSignal? = BY_NAME[signal]
    }
}
