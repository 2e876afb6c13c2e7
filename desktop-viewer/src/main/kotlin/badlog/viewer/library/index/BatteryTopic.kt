package badlog.viewer.library.index

import badlog.recording.PathName

/** The topic of the battery's voltage, by what teams call it; null when none looks like it. */
internal fun batteryTopic(topics: List<TopicSummary>): TopicSummary? {
    val volts = topics.filter { it.statistics.count > 0 && isVolts(it.unit) }
    return volts.firstOrNull { baseName(it) == "battery voltage" }
        ?: volts.firstOrNull { "battery" in words(it.name) && ("volt" in words(it.name) || it.unit.lowercase().startsWith("v")) }
        ?: volts.firstOrNull { baseName(it) in OTHER_NAMES }
        ?: volts.firstOrNull { topic -> POWER_PANELS.any { it in words(topic.name) } && "volt" in baseName(topic) }
}

private val OTHER_NAMES =
    setOf("batteryvoltage", "voltage battery", "input voltage", "system voltage", "robot voltage", "battery")
private val POWER_PANELS = listOf("pdp", "pdh", "power distribution")

private fun isVolts(unit: String) = unit.trim().lowercase() in setOf("v", "volt", "volts", "ul", "")

private fun words(name: String) = name.replace('_', ' ').lowercase()

private fun baseName(topic: TopicSummary) = words(PathName.baseNameOf(topic.name))
