package badlog.samples.generated.robot

import kotlin.math.PI
import kotlin.math.round

/**
 * A motor controller as the robot's code and a logger know it: what its last status frame said, in the steps and with the noise of its
 * sensors.
 *
 * @param encoder the counts of a turn of its shaft.
 */
internal class Device(val motor: Motor, private val chance: Chance, private val encoder: Int) {
    /** Turns of the motor's shaft. */
    var position = 0.0
        private set

    /** In 1/min of the motor's shaft. */
    var rpm = 0.0
        private set

    /** Of the stator, in A. */
    var statorCurrent = 0.0
        private set

    /** Of the supply, in A, of one motor. */
    var supplyCurrent = 0.0
        private set

    /** -1 to 1. */
    var output = 0.0
        private set

    /** At its terminals, in V. */
    var supplyVolts = 0.0
        private set

    /** In °C. */
    var temperature = 24.0
        private set

    /** The number of frames that arrived. */
    var frames = 0
        private set

    /** Whether it answers. */
    val isConnected: Boolean get() = motor.isConnected && motor.isPowered

    /** Sends a status frame. It is lost if the device is not there, and with a chance of [lost]. */
    fun sendFrame(volts: Double, lost: Double) {
        // Drawn in any case, so that a fault does not shift the noise.
        val luck = chance.between(0.0, 1.0)
        val noise = chance.around0(1.0)
        if (!isConnected || luck < lost) return
        frames++
        position = round(motor.position / (2 * PI) * encoder) / encoder
        rpm = round((motor.speed * 30 / PI + noise * 2.5) * 4) / 4
        statorCurrent = round((motor.current + noise * 0.25) * 8) / 8
        supplyCurrent = round((motor.supply / motor.count + noise * 0.12) * 8) / 8
        output = round(motor.output * 1024) / 1024
        // Leads from the power distribution to the motor, and 1/64 V of resolution.
        supplyVolts = round((volts - supplyCurrent * 0.003 + noise * 0.01) * 64) / 64
        temperature = round(motor.temperature)
    }
}
