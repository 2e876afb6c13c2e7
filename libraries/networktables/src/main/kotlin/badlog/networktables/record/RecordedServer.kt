package badlog.networktables.record

/**
 * The address of a NetworkTables server.
 *
 * @property host a name or an address; IPv6 in brackets.
 * @property port its port.
 */
class ServerAddress(val host: String, val port: Int) {
    override fun toString(): String = "$host:$port"
}

/**
 * A NetworkTables server to record.
 *
 * @property name its name for people, such as `robot`.
 * @property prefix the prefix of its topics' names in the log, such as `NT:`.
 * @property isMirror whether it repeats topics of the robot's server. Those are recorded from the robot's server only.
 * @property find returns its current address, or null if it does not answer. Called before each connection on a thread of its own, so it
 *   may block.
 */
class RecordedServer(val name: String, val prefix: String, val isMirror: Boolean = false, val find: () -> ServerAddress?) {
    companion object {
        /** The port of a robot's server. */
        const val ROBOT_PORT: Int = 5810

        /** The port of a Systemcore's own server. */
        const val SYSTEMCORE_PORT: Int = 6810

        /** The port at which the Driver Station of 2027 serves programs on its own computer. */
        const val DRIVER_STATION_PORT: Int = 6767
    }
}
