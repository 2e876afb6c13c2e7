package badlog.signals.battery

/**
 * A team's written records of its batteries.
 *
 * @property batteries the team's batteries.
 * @property used the names of the batteries in the robot, by the path of a log's file relative to the team's file, with slashes, or by
 *   match: `Qualification 12`.
 */
data class TeamBatteries(val batteries: List<TeamBattery> = emptyList(), val used: Map<String, String> = emptyMap()) {
    /** Returns the battery recorded for a match with logs at [places]; null if there is none. */
    fun usedFor(places: List<String>, match: String?): String? = places.firstNotNullOfOrNull(used::get) ?: match?.let(used::get)
}

/**
 * A battery of a team.
 *
 * @property name its name, as on its label.
 * @property bought the date on which it was new: `2025`, `2025-01` or `2025-01-31`; null if not known.
 * @property isRetired whether it is no longer used in matches.
 */
data class TeamBattery(val name: String, val bought: String? = null, val isRetired: Boolean = false) {
    /**
     * Returns its age in months at [date], which is written like [bought]. Null if it is not known, or if the battery was not bought by
     * then.
     */
    fun monthsUntil(date: String): Int? {
        val from = bought?.let(::monthsOf) ?: return null
        return (monthsOf(date) ?: return null).minus(from).takeIf { it >= 0 }
    }
}

// A year alone counts from its middle.
private fun monthsOf(date: String) = date.take(4).toIntOrNull()?.let { it * 12 + (date.drop(5).take(2).toIntOrNull() ?: 7) }
