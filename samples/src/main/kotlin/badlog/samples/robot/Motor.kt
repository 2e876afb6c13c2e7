package badlog.samples.robot

/** A CIM motor with a controller in brake mode. Speeds are in rad/s, torques in N·m. */
object Motor {
    private const val VOLTS_PER_SPEED = 12.0 / 558.0
    private const val TORQUE_PER_AMP = 2.41 / 131.0

    // 0.092 Ω of the motor itself, and its wires.
    private const val OHMS = 0.11

    /**
     * Returns the current in the windings, in A. Only the share [duty] of it comes from the battery, because the controller is a chopper.
     */
    fun windingAmps(duty: Double, volts: Double, speed: Double): Double = (duty * volts - VOLTS_PER_SPEED * speed) / OHMS

    fun torque(duty: Double, volts: Double, speed: Double): Double = TORQUE_PER_AMP * windingAmps(duty, volts, speed)

    /**
     * Adds the battery current of one motor to [load]; [volts] is the battery's last voltage. A braking motor turns its power into heat
     * itself.
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
 * The current of one channel of the power distribution. It is linear in the battery's voltage, `amps = offset + conductance * volts`, so
 * that the voltage can be solved without iterating.
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
