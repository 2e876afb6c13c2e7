package badlog.viewer.recording

import badlog.recording.PathName

/**
 * Which of [topics] is the battery's voltage, by what teams call it; null when none looks like it.
 *
 * @param nameOf its full name.
 * @param unitOf its unit.
 */
internal fun <T> batteryAmong(topics: List<T>, nameOf: (T) -> String, unitOf: (T) -> String): T? {
    val volts = topics.filter { isVolts(unitOf(it)) }.map { Candidate(it, words(nameOf(it)), unitOf(it).lowercase()) }
    val battery = volts.firstOrNull { it.base == "battery voltage" }
        ?: volts.firstOrNull { "battery" in it.name && ("volt" in it.name || it.unit.startsWith("v")) }
        ?: volts.firstOrNull { it.base in OTHER_NAMES }
        ?: volts.firstOrNull { candidate -> POWER_PANELS.any { it in candidate.name } && "volt" in candidate.base }
    return battery?.topic
}

private class Candidate<T>(val topic: T, val name: String, val unit: String) {
    val base = PathName.baseNameOf(name)
}

private val OTHER_NAMES =
    setOf("batteryvoltage", "voltage battery", "input voltage", "system voltage", "robot voltage", "battery")
private val POWER_PANELS = listOf("pdp", "pdh", "power distribution")

private fun isVolts(unit: String) = unit.trim().lowercase() in setOf("v", "volt", "volts", "ul", "")

private fun words(name: String) = name.replace('_', ' ').lowercase()
