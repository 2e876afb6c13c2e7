package badlog.networktables.record

/**
 * Returns the server of a robot, and with [isOfAll] also those that a robot of 2027 and its Driver Station have.
 *
 * @param find returns where the robot's server answers now, or null if it does not; see [RecordedServer.find].
 */
fun robotServers(isOfAll: Boolean, find: () -> ServerAddress?): List<RecordedServer> {
    val place = LastPlace(find)
    val robot = RecordedServer("robot", "NT:", find = place::find)
    if (!isOfAll) return listOf(robot)
    val systemcore = RecordedServer("Systemcore", "Systemcore:") {
        place.found?.let { ServerAddress(it.host, RecordedServer.SYSTEMCORE_PORT) }
    }
    val station = RecordedServer("Driver Station", "DS:", isMirror = true) {
        ServerAddress("localhost", RecordedServer.DRIVER_STATION_PORT)
    }
    return listOf(robot, systemcore, station)
}

/** Where the robot answered last: its other server is there, too. */
private class LastPlace(private val search: () -> ServerAddress?) {
    @Volatile
    var found: ServerAddress? = null
        private set

    fun find(): ServerAddress? = search()?.also { found = it }
}
