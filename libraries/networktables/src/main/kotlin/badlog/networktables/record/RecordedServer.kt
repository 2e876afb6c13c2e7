package badlog.networktables.record

/**
 * Where a NetworkTables server may be.
 *
 * @property host a name or an address; IPv6 in brackets.
 * @property port its port.
 */
class ServerAddress(val host: String, val port: Int) {
    override fun toString(): String = "$host:$port"
}

/**
 * A NetworkTables server that is recorded.
 *
 * @property name its name for people, such as `robot`.
 * @property prefix what its topics' names begin with in the log, such as `NT:`.
 * @property isMirror whether it repeats the topics of the robot's server, which are then only recorded from there.
 * @property find returns where it answers now, or null if it does not. Called on a thread of its own before each connection; may take its
 *   time.
 */
class RecordedServer(val name: String, val prefix: String, val isMirror: Boolean = false, val find: () -> ServerAddress?) {
    companion object {
        /** The port of a robot's server. */
        const val ROBOT_PORT: Int = 5810

        /** The port of the server that a Systemcore itself has. */
        const val SYSTEMCORE_PORT: Int = 6810

        /** The port at which the Driver Station of 2027 serves programs on its own computer. */
        const val DRIVER_STATION_PORT: Int = 6767
    }
}
