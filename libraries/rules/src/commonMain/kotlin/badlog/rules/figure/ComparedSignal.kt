package badlog.rules.figure

/**
 * A signal of whose topics there are figures to compare.
 *
 * @property least what is nearer to the others is as they are, in the unit of the signal.
 * @property isRatio whether a difference is a share of the usual, and not a number of its unit as with voltages.
 * @property isWorseBelow whether less than usual is what is worth a look, and not more.
 * @property isOfMotor whether it is of one motor: of one that takes less than usual while the robot drives, something is wrong, too.
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
        private val CURRENT = listOf(Measure.AUTONOMOUS, Measure.TELEOP, Measure.DRIVING, Measure.ENABLED)

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
            ComparedSignal(FigureKey.RESISTANCE, listOf(Measure.RESISTANCE), least = 3.0),
        )

        private val BY_NAME = ALL.associateBy { it.signal }

        fun of(signal: String): ComparedSignal? = BY_NAME[signal]
    }
}
