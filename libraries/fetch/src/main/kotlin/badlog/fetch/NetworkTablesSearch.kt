package badlog.fetch

import java.time.Duration

/**
 * Searches for the NetworkTables server of [robot]: a team's number, or an address with or without that server's port.
 *
 * @param addresses the addresses at which the robot may answer, the most likely first.
 * @param patience the maximum time to wait for an answer.
 */
class NetworkTablesSearch(robot: String, addresses: List<RobotAddress>, private val patience: Duration = Patience().connect) {
    private val servers = addresses.map { address ->
        val port = PORT.find(robot)?.groupValues?.get(1)?.toInt() ?: address.networkTablesPort
        RobotAddress(address.host, emptyList(), port)
    }

    /** The searched hosts, as text for readers. */
    val places: String = servers.joinToString { it.host }

    /** Returns the first address that answers, with the server's port; null if none does. Waits for the answer. */
    fun find(): RobotAddress? = answering(servers, patience).firstOrNull()

    private companion object {
        val PORT = Regex(":(\\d{1,5})$")
    }
}
