package badlog.samples.robot

/** A CIM motor behind a controller in brake mode. Its speed is in rad/s, its torque in N·m. */
object Motor {
    private const val VOLTS_PER_SPEED = 12.0 / 558.0
    private const val TORQUE_PER_AMP = 2.41 / 131.0

    // The motor's own 0.092, and its wires.
    private const val OHMS = 0.11

    /**
     * The current in the windings. The battery gives only the share [duty] of it, because the controller is a chopper.
     */
    fun windingAmps(duty: Double, volts: Double, speed: Double): Double = (duty * volts - VOLTS_PER_SPEED * speed) / OHMS

    fun torque(duty: Double, volts: Double, speed: Double): Double = TORQUE_PER_AMP * windingAmps(duty, volts, speed)

    /**
     * Adds what one motor draws from the battery, which was at [volts] before. A braking motor turns its power into
     * heat itself.
     */
    fun load(load: Load, duty: Double, volts: Double, speed: Double) {
        if (duty * windingAmps(duty, volts, speed) <= 0) {
            load.draw(0.0)
        } else {
            load.draw(offset = -duty * VOLTS_PER_SPEED * speed / OHMS, conductance = duty * duty / OHMS)
        }
    }
}

/**
 * What one channel of the power distribution draws from the battery. A motor's current is a straight line over the
 * battery's voltage, `amps = offset + conductance * volts`, which lets the voltage be solved without iterating.
 */
class Load {
    var offset = 0.0
        private set
    var conductance = 0.0
        private set

    fun draw(offset: Double, conductance: Double = 0.0) {
        this.offset = offset
        this.conductance = conductance
    }

    fun amps(volts: Double): Double = offset + conductance * volts
}
