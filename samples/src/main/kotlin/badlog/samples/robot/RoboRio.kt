package badlog.samples.robot

/** The robot's computer, which protects itself against a low battery and has limited time in a loop. */
class RoboRio(private val noise: Noise) {
    private var brownoutSeconds = 0.0
    var batteryVolts = 0.0
        private set
    var isBrownedOut = false
        private set
    var loopMillis = 0.0
        private set
    var cpuLoad = 35.0
        private set
    var canLoad = 58.0
        private set

    /** The number of CAN messages that failed since the start. */
    var canErrors = 0
        private set

    /** Cuts all outputs below [BROWNOUT_VOLTS], until the battery has recovered. */
    fun checkBrownout(volts: Double, seconds: Double) {
        batteryVolts = volts + noise.around(0.012)
        brownoutSeconds = if (isBrownedOut) brownoutSeconds + seconds else 0.0
        if (batteryVolts < BROWNOUT_VOLTS) {
            isBrownedOut = true
        } else if (batteryVolts > RECOVERY_VOLTS && brownoutSeconds > MIN_BROWNOUT) {
            isBrownedOut = false
        }
    }

    fun work(enabled: Boolean, stallSeconds: Double, canIsBusy: Boolean, canFails: Boolean) {
        if (canFails) canErrors += ERRORS_PER_LOOP
        val wanted = (if (enabled) 52.0 else 34.0) + noise.around(7.0) + if (stallSeconds > 0) 260 else 0
        cpuLoad = (cpuLoad + (wanted - cpuLoad) * 0.15).coerceAtMost(99.0)
        canLoad += ((if (canIsBusy) 97.0 else 58.0) + noise.around(2.0) - canLoad) * 0.3
        val late = if (noise.unit() < 0.006) noise.unit() * 7 else 0.0
        loopMillis = (if (enabled) 8.4 else 5.1) + noise.around(0.45) + late + stallSeconds * 1000
    }

    companion object {
        const val BROWNOUT_VOLTS = 6.75
        private const val RECOVERY_VOLTS = 7.5
        private const val MIN_BROWNOUT = 0.16
        private const val ERRORS_PER_LOOP = 8
    }
}
