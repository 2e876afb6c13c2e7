package badlog.analysis

import badlog.plot.Span
import badlog.plot.StateRuns
import badlog.recording.PathName
import badlog.recording.Topic

/**
 * A stretch over which the robot was enabled.
 *
 * @property span where on the x axis.
 * @property isAutonomous whether it was under its own control; false when a driver was, or nothing tells.
 */
public data class EnabledSpan(public val span: Span, public val isAutonomous: Boolean)

/**
 * When the robot was enabled, in the order of x: where the topic called `Enabled` or `Robot Enabled`, in any folder, is not 0.
 * A topic called `Autonomous` or `Auto` beside it tells when under its own control. Empty when no topic tells, and when x goes
 * backwards.
 */
public fun LogView.enabledSpans(): List<EnabledSpan> {
    val enabled = runsWhereSet(findFlag("enabled", "robot enabled", "isenabled") ?: return emptyList())
    val autonomous = findFlag("autonomous", "auto", "isautonomous")?.let { runsWhereSet(it) }.orEmpty()
    return enabled.flatMap { split(it, autonomous) }
}

private fun LogView.findFlag(vararg names: String): Topic? = recording.topics.firstOrNull { topic ->
    topic.samples.isNotEmpty() && PathName.baseNameOf(topic.name).replace('_', ' ').lowercase().substringAfterLast(':') in names
}

private fun LogView.runsWhereSet(topic: Topic): List<Span> {
    val series = seriesOf(topic).data
    if (!series.isOrdered || series.size == 0) return emptyList()
    val flags = Series(series.x, DoubleArray(series.size) { if (series.y[it] == 0.0 || series.y[it].isNaN()) 0.0 else 1.0 })
    val runs = StateRuns(flags, series.x.last())
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
