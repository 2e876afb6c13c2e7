package badlog.samples.robot

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
