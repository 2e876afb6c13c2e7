package badlog.samples.fault

import badlog.samples.robot.Noise

/**
 * The measurement errors between a robot and its log. These are lagging and noisy current sensors, limited resolution, and late frames on
 * the CAN bus, which repeat the previous row's value.
 */
internal class Instruments(private val noise: Noise) {
    private val isLate = HashMap<String, Boolean>()
    private val lagSeconds = 0.03 + 0.12 * noise.unit()
    private val ampsDeviation = 0.2 + 0.5 * noise.unit()
    private val lateShare = 0.01 + 0.09 * noise.unit()

    /** Begins a row: each device's frame arrives in time or not; none arrives while the bus [isCut]. */
    fun nextRow(isCut: Boolean) {
        for (device in isLate.keys) isLate[device] = noise.unit() < lateShare || isCut
    }

    /** Returns a supplier of the measured values of [actual] for the topic [name] in [unit]. */
    fun measuring(name: String, unit: String, actual: () -> Double?): () -> Double? {
        val isOfBus = BUS.any { name.startsWith(it) }
        val device = name.substringBeforeLast(' ')
        if (isOfBus) isLate[device] = false
        val sensor = when {
            unit == "A" && isOfBus -> lagging(actual)
            name == "System/Battery Voltage" -> stepped(STEP_VOLTS) { actual()?.plus(noise.around(DEVIATION_VOLTS)) }
            unit == "m/s" -> stepped(STEP_SPEED, actual)
            unit == "m" -> stepped(STEP_METERS, actual)
            else -> actual
        }
        if (!isOfBus) return sensor
        var last: Double? = null
        return {
            if (isLate[device] != true || last == null) last = sensor()
            last
        }
    }

    private fun lagging(actual: () -> Double?): () -> Double? {
        var amps = 0.0
        return stepped(STEP_AMPS) {
            val now = actual() ?: 0.0
            amps += (now - amps) * (ROW / (ROW + lagSeconds))
            if (amps < RESTING) amps = 0.0
            if (amps == 0.0) 0.0 else maxOf(0.0, amps + noise.around(ampsDeviation))
        }
    }

    private fun stepped(step: Double, actual: () -> Double?): () -> Double? = { actual()?.let { Math.rint(it / step) * step } }

    private companion object {
        val BUS = listOf("Drivetrain/", "Swerve/", "Elevator/", "PDP/", "Intake/")

        /** The time from one row of the log to the next, in s. */
        const val ROW = 0.04
        const val STEP_AMPS = 0.125
        const val STEP_VOLTS = 0.02
        const val DEVIATION_VOLTS = 0.03
        const val STEP_SPEED = 0.01
        const val STEP_METERS = 0.001
        const val RESTING = 0.1
    }
}
