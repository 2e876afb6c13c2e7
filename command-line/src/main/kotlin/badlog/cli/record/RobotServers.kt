package badlog.cli.record

import badlog.cli.fetch.Robots
import badlog.fetch.RobotAddress
import badlog.fetch.answering
import badlog.record.RecordedServer
import badlog.record.ServerAddress

/**
 * The NetworkTables servers of [robot], a team's number or an address with or without a port.
 *
 * @throws IllegalArgumentException if it is neither; the message is one sentence for the user.
 */
internal class RobotServers(robot: String, private val robots: Robots) {
    private val addresses = robots.addressesOf(robot, null).map { address ->
        val port = PORT.find(robot)?.groupValues?.get(1)?.toInt() ?: address.networkTablesPort
        RobotAddress(address.host, emptyList(), port)
    }

    @Volatile
    private var found: ServerAddress? = null

    /** Where the robot is looked for, for people. */
    val places: String = addresses.joinToString { it.host }

    /** Returns the robot's server, and with [isOfAll] also those that a robot of 2027 and its Driver Station have. */
    fun servers(isOfAll: Boolean): List<RecordedServer> {
        val robot = RecordedServer("robot", "NT:") { find() }
        if (!isOfAll) return listOf(robot)
        val systemcore = RecordedServer("Systemcore", "Systemcore:") {
            found?.let { ServerAddress(it.host, RecordedServer.SYSTEMCORE_PORT) }
        }
        val station = RecordedServer("Driver Station", "DS:", isMirror = true) {
            ServerAddress("localhost", RecordedServer.DRIVER_STATION_PORT)
        }
        return listOf(robot, systemcore, station)
    }

    private fun find(): ServerAddress? =
        answering(addresses, robots.patience.connect).firstOrNull()?.let { ServerAddress(it.host, it.port) }.also { found = it ?: found }

    private companion object {
        val PORT = Regex(":(\\d{1,5})$")
    }
}
