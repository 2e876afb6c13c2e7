package badlog.samples.generated.robot

import kotlin.math.PI
import kotlin.math.round

/**
 * A motor controller as seen by the robot's code and a logger: the values of its last status frame, with the resolution and noise of its
 * sensors.
 *
 * @param encoder the counts per turn of its shaft.
 */
internal class Device(val motor: Motor, private val chance: Chance, private val encoder: Int) {
    /** The position of the motor's shaft, in turns. */
    var position = 0.0
        private set

    /** The speed of the motor's shaft, in 1/min. */
    var rpm = 0.0
        private set

    /** The current in the stator, in A. */
    var statorCurrent = 0.0
        private set

    /** The supply current of one motor, in A. */
    var supplyCurrent = 0.0
        private set

    /** The output, -1 to 1. */
    var output = 0.0
        private set

    /** The voltage at its terminals, in V. */
    var supplyVolts = 0.0
        private set

    /** The temperature in °C. */
    var temperature = 24.0
        private set

    /** The number of frames that arrived. */
    var frames = 0
        private set

    /** Whether it answers. */
    val isConnected: Boolean get() = motor.isConnected && motor.isPowered

    /** Sends a status frame. It is lost if the device is not connected, or with probability [lost]. */
    fun sendFrame(volts: Double, lost: Double) {
        // Always drawn, so that a fault does not shift the noise.
        val luck = chance.between(0.0, 1.0)
        val noise = chance.normal(1.0)
        if (!isConnected || luck < lost) return
        frames++
        position = round(motor.position / (2 * PI) * encoder) / encoder
        rpm = round((motor.speed * 30 / PI + noise * 2.5) * 4) / 4
        statorCurrent = round((motor.current + noise * 0.25) * 8) / 8
        supplyCurrent = round((motor.supply / motor.count + noise * 0.12) * 8) / 8
        output = round(motor.output * 1024) / 1024
        // Includes the leads from the power distribution to the motor, and a resolution of 1/64 V.
        supplyVolts = round((volts - supplyCurrent * 0.003 + noise * 0.01) * 64) / 64
        temperature = round(motor.temperature)
    }
}
