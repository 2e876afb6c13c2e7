package badlog.samples.robot

/**
 * A 12 V lead-acid battery. Its resting voltage falls with its charge. It has an immediate resistance, and a second one that builds up over
 * seconds, when acid near the plates is used up faster than it is replaced.
 *
 * @param ohms the immediate resistance, including leads, main breaker and connectors.
 * @param slowOhms the resistance that builds up.
 * @param ampHours its capacity.
 * @param charge the charge, 0 (empty) to 1 (full).
 */
class Battery(private val ohms: Double, private val slowOhms: Double, private val ampHours: Double, private var charge: Double) {
    private var slowVolts = 0.0

    /** The resistance that a bad contact adds to the lead, in Ω. */
    var contactOhms = 0.0

    var volts = restingVolts()
        private set

    /** Solves for the voltage of the battery with [loads], and discharges it for [seconds]. */
    fun supply(loads: List<Load>, seconds: Double) {
        var offset = 0.0
        var conductance = 0.0
        for (load in loads) {
            offset += load.offset
            conductance += load.conductance
        }
        val series = ohms + contactOhms
        volts = (restingVolts() - slowVolts - series * offset) / (1 + series * conductance)
        val amps = offset + conductance * volts
        slowVolts += (amps * slowOhms - slowVolts) * seconds / SLOW_SECONDS
        charge -= amps * seconds / (ampHours * 3600)
    }

    private fun restingVolts() = 11.6 + 1.2 * charge
}

private const val SLOW_SECONDS = 2.5
