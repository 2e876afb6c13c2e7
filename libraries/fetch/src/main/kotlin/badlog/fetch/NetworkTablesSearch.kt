package badlog.fetch

import java.time.Duration

/**
 * Looks for the NetworkTables server of the robot that a person named [robot]: a team's number, or an address with or without the port of
 * that server.
 *
 * @param addresses where that robot may answer, the most likely place first.
 * @param patience how long to wait for an answer.
 */
class NetworkTablesSearch(robot: String, addresses: List<RobotAddress>, private val patience: Duration = Patience().connect) {
    private val servers = addresses.map { address ->
        val port = PORT.find(robot)?.groupValues?.get(1)?.toInt() ?: address.networkTablesPort
        RobotAddress(address.host, emptyList(), port)
    }

    /** Where the robot is looked for, for people. */
    val places: String = servers.joinToString { it.host }

    /** Returns where it answers now, with the server's port; null if nothing does. Waits for that. */
    fun find(): RobotAddress? = answering(servers, patience).firstOrNull()

    private companion object {
        val PORT = Regex(":(\\d{1,5})$")
    }
}
