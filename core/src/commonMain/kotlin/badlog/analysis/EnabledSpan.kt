package badlog.analysis

import badlog.recording.PathName
import badlog.recording.Topic

/**
 * A stretch over which the robot was enabled.
 *
 * @property span where on the x axis.
 * @property isAutonomous whether it was under its own control; false when a driver was, or it is unknown.
 */
public data class EnabledSpan(public val span: Span, public val isAutonomous: Boolean)

/**
 * When the robot was enabled, in the order of x: where the topic called `Enabled` or `Robot Enabled`, in any folder, is not 0.
 * A topic called `Autonomous` or `Auto` beside it shows when under its own control. In a WPILOG those of the driver station
 * come before others, then the bits of `FMSControlData`, and the last value holds until the recording's end. Empty when no
 * topic tells, and when x goes backwards.
 */
public fun LogView.enabledSpans(): List<EnabledSpan> {
    val named = findFlag(ENABLED_NAMES)
    val control = findFlag(CONTROL_NAMES)
    if (control != null && (named == null || !isOfDriverStation(named))) {
        return spansOf(control, control) { bit -> { word -> (word.toInt() shr bit) and 1 == 1 } }
    }
    return spansOf(named ?: return emptyList(), findFlag(AUTONOMOUS_NAMES)) { { it != 0.0 } }
}

/** Whether the recording tells when the robot was enabled; where not, [enabledSpans] is empty and means nothing. */
public val LogView.knowsEnabled: Boolean
    get() = (findFlag(CONTROL_NAMES) ?: findFlag(ENABLED_NAMES))?.let { seriesOf(it).data.isOrdered } ?: false

/** Whether the recording tells [enabledSpans] under the robot's own control from those under a driver's. */
public val LogView.knowsAutonomous: Boolean
    get() = knowsEnabled && (findFlag(CONTROL_NAMES) ?: findFlag(AUTONOMOUS_NAMES)) != null

/** The topics that [enabledSpans] looks at. */
public fun LogView.enabledTopics(): List<Topic> =
    listOfNotNull(findFlag(ENABLED_NAMES), findFlag(CONTROL_NAMES), findFlag(AUTONOMOUS_NAMES))

private fun LogView.spansOf(enabled: Topic, autonomous: Topic?, isSet: (bit: Int) -> (Double) -> Boolean): List<EnabledSpan> {
    val alone = autonomous?.let { runsWhere(it, isSet(AUTONOMOUS_BIT)) }.orEmpty()
    return runsWhere(enabled, isSet(ENABLED_BIT)).flatMap { split(it, alone) }
}

/** Whether a topic called [name], in any folder, says by 1 and 0 when the robot was enabled. */
public fun isNameOfEnabled(name: String): Boolean = flagOf(name) in ENABLED_NAMES

/** [topicName] as the driver station's flags are told apart, however it is written. */
private fun flagOf(topicName: String) = PathName.baseNameOf(topicName).replace('_', ' ').lowercase().substringAfterLast(':')

private fun LogView.findFlag(names: Set<String>): Topic? {
    val found = recording.topics.filter { it.samples.isNotEmpty() && flagOf(it.name) in names }
    return found.firstOrNull(::isOfDriverStation) ?: found.firstOrNull()
}

/** Whether WPILib, or a logger above it, has taken [topic] from the driver station itself. */
private fun isOfDriverStation(topic: Topic) = topic.name.startsWith("DS:") || "DriverStation" in topic.name

private fun LogView.runsWhere(topic: Topic, isSet: (Double) -> Boolean): List<Span> {
    val series = seriesOf(topic).data
    if (!series.isOrdered || series.size == 0) return emptyList()
    val flags = Series(
        series.x,
        DoubleArray(series.size) { if (!series.y[it].isNaN() && isSet(series.y[it])) 1.0 else 0.0 },
    )
    val end = if (topic.times == null) series.x.last() else xAxis.range?.endInclusive
    val runs = StateRuns(flags, end ?: series.x.last())
    return runs.states.indices.filter { runs.states[it] == 1 }.map { Span(runs.from[it], runs.to[it]) }
}

/** Cuts [enabled] where [autonomous] begins and ends. */
private fun split(enabled: Span, autonomous: List<Span>): List<EnabledSpan> {
    val pieces = ArrayList<EnabledSpan>()
    var at = enabled.from
    for (auto in autonomous) {
        val from = maxOf(auto.from, at)
        val to = minOf(auto.to, enabled.to)
        if (to <= from) continue
        if (from > at) pieces += EnabledSpan(Span(at, from), false)
        pieces += EnabledSpan(Span(from, to), true)
        at = to
    }
    if (enabled.to > at || pieces.isEmpty()) pieces += EnabledSpan(Span(at, enabled.to), false)
    return pieces
}

private val ENABLED_NAMES = setOf("enabled", "robot enabled", "isenabled")
private val AUTONOMOUS_NAMES = setOf("autonomous", "auto", "isautonomous")
private val CONTROL_NAMES = setOf("fmscontroldata")

// Of the driver station's control word.
private const val ENABLED_BIT = 0
private const val AUTONOMOUS_BIT = 1
