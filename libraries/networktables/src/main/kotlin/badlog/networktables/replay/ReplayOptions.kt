package badlog.networktables.replay

import java.net.InetAddress

/**
 * Settings of a replay.
 *
 * @property port the port to which dashboards connect; 0 for any free one. Most dashboards only know [DEFAULT_PORT].
 * @property address the address at which dashboards can connect. Default: this computer only.
 * @property speed the number of seconds of the recording that pass in a second; above 0.
 * @property isLooping whether it starts over when it reaches the end.
 * @property range the range to replay, on the recording's x axis and in its unit; null for all.
 * @property prefix the prefix of each topic's name, such as `/badlog`; empty for the robot's own names.
 * @throws IllegalArgumentException if one of them is out of range.
 */
class ReplayOptions(
    val port: Int = DEFAULT_PORT,
    val address: InetAddress = InetAddress.getLoopbackAddress(),
    val speed: Double = 1.0,
    val isLooping: Boolean = false,
    val range: ClosedFloatingPointRange<Double>? = null,
    val prefix: String = "",
) {
    init {
        require(port in 0..0xffff) { "A port is a number from 1 to 65535, or 0 for any that is free, not $port." }
        requireSpeed(speed)
        require(range == null || (range.start.isFinite() && range.endInclusive.isFinite() && range.start <= range.endInclusive)) {
            "A replay needs a range that begins before it ends, not $range."
        }
    }

    companion object {
        /** The port of NetworkTables 4. */
        const val DEFAULT_PORT: Int = 5810
    }
}
