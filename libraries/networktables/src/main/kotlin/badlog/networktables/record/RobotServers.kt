package badlog.networktables.record

/**
 * Returns a robot's server and, if [isOfAll], the other servers of a 2027 robot and its Driver Station.
 *
 * @param find returns the current address of the robot's server, or null if it does not answer; see [RecordedServer.find].
 */
fun robotServers(isOfAll: Boolean, find: () -> ServerAddress?): List<RecordedServer> {
    val lastAddress = LastAddress(find)
    val robot = RecordedServer("robot", "NT:", find = lastAddress::find)
    if (!isOfAll) return listOf(robot)
    val systemcore = RecordedServer("Systemcore", "Systemcore:") {
        lastAddress.found?.let { ServerAddress(it.host, RecordedServer.SYSTEMCORE_PORT) }
    }
    val station = RecordedServer("Driver Station", "DS:", isMirror = true) {
        ServerAddress("localhost", RecordedServer.DRIVER_STATION_PORT)
    }
    return listOf(robot, systemcore, station)
}

/** The address at which the robot last answered. Its other server has the same host. */
private class LastAddress(private val search: () -> ServerAddress?) {
    @Volatile
    var found: ServerAddress? = null
        private set

    fun find(): ServerAddress? = search()?.also { found = it }
}
