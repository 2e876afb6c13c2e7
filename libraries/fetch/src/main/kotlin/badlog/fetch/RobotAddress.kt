package badlog.fetch

import java.time.Duration

/**
 * A user of a robot's computer.
 *
 * @property user the name.
 * @property password the computer's default password; empty if there is none.
 */
class Login(val user: String, val password: String) {
    /** Returns only the name, because passwords are never printed. */
    override fun toString(): String = user
}

/**
 * An address at which a robot may answer.
 *
 * @property host a name or an address.
 * @property logins the users to try, in this order.
 * @property port the port of SFTP.
 * @property networkTablesPort the port of its NetworkTables server, which reports whether it is enabled.
 * @property name its name for readers.
 */
class RobotAddress(
    val host: String,
    val logins: List<Login>,
    val port: Int = SFTP_PORT,
    val networkTablesPort: Int = NETWORK_TABLES_PORT,
    val name: String = if (port == SFTP_PORT) host else "$host:$port",
) {
    override fun toString(): String = name

    companion object {
        private const val SFTP_PORT = 22
        private const val NETWORK_TABLES_PORT = 5810
        private const val DRIVER_STATION_SECONDS = 1L
        private const val MAX_PORT = 65_535

        /** The largest possible team number; addresses have no room for a larger one. */
        private const val MAX_TEAM = 25_599

        private val ROBORIO = Login("lvuser", "")
        private val SYSTEMCORE = Login("systemcore", "systemcore")

        /**
         * Returns the addresses at which [robot] may answer, the most likely first. A team number stands for a roboRIO and a Systemcore on
         * the field's network and over USB. Any other [robot] is one address, such as `10.10.14.2`, `robot.local`, `pit@10.10.14.2` or
         * `localhost:2222`.
         *
         * @param user the user to try in place of the known ones, or null; a user in [robot] takes precedence.
         * @throws IllegalArgumentException if [robot] is neither; the message is one sentence for the user.
         */
        fun of(robot: String, user: String? = null): List<RobotAddress> {
            val team = robot.toIntOrNull()
            if (team != null) {
                require(team in 1..MAX_TEAM) {
                    "“$robot” is not a team number, 1 to $MAX_TEAM; type one, or the robot's address."
                }
                return ofTeam(team, user)
            }
            val parts = ADDRESS.matchEntire(robot)
            val port = parts?.groups?.get("port")?.value?.toIntOrNull() ?: SFTP_PORT
            require(parts != null && port in 1..MAX_PORT) {
                "“$robot” is neither a team number nor an address; type 1014, 10.10.14.2 or user@robot.local."
            }
            val named = parts.groups["user"]?.value ?: user
            return listOf(RobotAddress(parts.groups["host"]!!.value, logins(named, ROBORIO, SYSTEMCORE), port))
        }

        /**
         * Returns the same as [of]. For a team's number, the robot connected to a Driver Station on this computer comes first, unless it
         * belongs to another team. Throws the same exceptions.
         */
        fun besideDriverStation(robot: String, user: String? = null): List<RobotAddress> =
            beside(robot, user) { robotOfDriverStation(Duration.ofSeconds(DRIVER_STATION_SECONDS)) }

        internal fun beside(robot: String, user: String?, ask: () -> String?): List<RobotAddress> {
            val known = of(robot, user)
            val team = robot.toIntOrNull() ?: return known
            val host = ask() ?: return known
            val isOurs = !host.startsWith("10.") || host.startsWith("10.${team / 100}.${team % 100}.")
            if (!isOurs) return known
            val first = known.find { it.host == host } ?: RobotAddress(host, logins(user, SYSTEMCORE, ROBORIO))
            return listOf(first) + (known - first)
        }

        private fun ofTeam(team: Int, user: String?): List<RobotAddress> {
            val radio = "10.${team / 100}.${team % 100}.2"
            return listOf(
                RobotAddress(radio, logins(user, ROBORIO, SYSTEMCORE)),
                RobotAddress("172.22.11.2", logins(user, ROBORIO)),
                RobotAddress("roboRIO-$team-frc.local", logins(user, ROBORIO)),
                RobotAddress("robot.local", logins(user, SYSTEMCORE)),
                RobotAddress("172.26.0.1", logins(user, SYSTEMCORE)),
                RobotAddress("172.27.0.1", logins(user, SYSTEMCORE)),
                RobotAddress("172.30.0.1", logins(user, SYSTEMCORE)),
            )
        }

        /** Returns only [user], with its known password; all known logins if [user] is null. */
        private fun logins(user: String?, vararg known: Login): List<Login> =
            if (user == null) known.toList() else listOf(listOf(ROBORIO, SYSTEMCORE).find { it.user == user } ?: Login(user, ""))

        private val ADDRESS =
            Regex(
                "(?:(?<user>[^@\\s:/]+)@)?(?<host>[A-Za-z0-9](?:[A-Za-z0-9.-]*[A-Za-z0-9])?|\\[[0-9A-Fa-f:.%a-z]+])(?::(?<port>\\d{1,5}))?",
            )
    }
}
