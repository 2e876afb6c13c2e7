package badlog.core.analysis

import badlog.core.recording.Topic

/**
 * A time during which the robot was enabled.
 *
 * @property span where on the x axis.
 * @property isAutonomous whether it was under its own control; false when a driver was, or it is unknown.
 */
public data class EnabledSpan(public val span: Span, public val isAutonomous: Boolean)

/**
 * Returns when the robot was enabled, in the order of x, according to the [modes][LogView.modes]. The last value of a topic with
 * times of its own holds until the recording's end. Empty if no topic shows it, or if x goes backwards.
 */
public fun LogView.enabledSpans(): List<EnabledSpan> {
    val alone = modes.autonomous?.let(::spansOf).orEmpty()
    return modes.enabled?.let(::spansOf).orEmpty().flatMap { split(it, alone) }
}

/** Whether the recording shows when the robot was enabled; if it doesn't, [enabledSpans] is empty and means nothing. */
public val LogView.knowsEnabled: Boolean get() = modes.enabled?.let { topicOf(it) }?.let { seriesOf(it).data.isOrdered } ?: false

/** Whether the recording shows which [enabledSpans] were autonomous. */
public val LogView.knowsAutonomous: Boolean get() = knowsEnabled && modes.autonomous?.let { topicOf(it) } != null

/** Returns the topics that [enabledSpans] uses. */
public fun LogView.enabledTopics(): List<Topic> = listOfNotNull(modes.enabled, modes.autonomous).mapNotNull { topicOf(it) }.distinct()

private fun LogView.topicOf(flag: FlagTopic) = recording.topics.find { it.name == flag.topic && seriesOf(it).data.size > 0 }

private fun LogView.spansOf(flag: FlagTopic): List<Span> {
    val topic = topicOf(flag) ?: return emptyList()
    val line = seriesOf(topic)
    val series = line.data
    if (!series.isOrdered) return emptyList()
    val states = line.states.orEmpty()
    val flags = Series(series.x, DoubleArray(series.size) { if (flag.reading.isSet(series.y[it], states)) 1.0 else 0.0 })
    val end = if (line.holds || topic.isSparse) xAxis.range?.endInclusive else null
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
