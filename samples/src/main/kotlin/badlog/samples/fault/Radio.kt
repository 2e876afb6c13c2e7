package badlog.samples.fault

import badlog.samples.bag.BagLog
import badlog.samples.robot.Mishaps
import badlog.samples.robot.Noise
import badlog.samples.robot.Robot

/** The link between robot and driver station, as the robot's program sees it. */
internal class Radio(private val mishaps: Mishaps, private val noise: Noise) {
    private var lossPercent = 0.0
    var isLinked = true
        private set

    /** The trip time of a packet, in milliseconds; null while none arrives. */
    var tripMillis: Double? = null
        private set
    val packetLoss: Double? get() = lossPercent.takeIf { isLinked }

    fun pass(time: Double) {
        isLinked = mishaps.hasLink(time)
        val burst = if (noise.unit() < 0.001) 2.5 else 0.0
        lossPercent = maxOf(lossPercent * 0.97, burst)
        tripMillis = if (isLinked) 7 + noise.unit() * 4 + if (noise.unit() < 0.01) 12 * noise.unit() else 0.0 else null
    }
}

/** Creates the topics that the bundled samples lack: errors on the bus, and the radio. */
internal fun BagLog.createFaultTopics(robot: Robot, radio: Radio) {
    number("System/CAN Receive Errors", "", 0) { robot.roboRio.canErrors.toDouble() }
    flag("System/DS Connected") { radio.isLinked }
    number("System/Trip Time", "ms", 1) { radio.tripMillis }
    number("System/Packet Loss", "%", 1) { radio.packetLoss }
}
