package badlog.core.analysis

import badlog.core.recording.Topic

/**
 * A time during which the robot was enabled.
 *
 * @property span its part of the x axis.
 * @property isAutonomous whether the robot was in autonomous mode; false if a driver controlled it, or if the mode is unknown.
 * @property isTest whether the robot was in test mode, which is called utility from 2027 on; no match is played in that mode.
 * @property opMode the name of the op mode that a robot ran, from 2027 on; null if there is none.
 */
public data class EnabledSpan(
    public val span: Span,
    public val isAutonomous: Boolean,
    public val isTest: Boolean = false,
    public val opMode: String? = null,
)

/**
 * Returns the spans in which the robot was enabled, in the order of x, according to the [modes][LogView.modes]. The last value of a topic
 * with times of its own holds until the recording's end. Empty if no topic shows when it was enabled, or if x goes backwards.
 */
public fun LogView.enabledSpans(): List<EnabledSpan> {
    val autonomous = modes.autonomous?.let(::spansOf).orEmpty()
    val tests = modes.test?.let(::spansOf).orEmpty()
    val names = modes.opMode?.let(::textsOf)
    return modes.enabled?.let(::spansOf).orEmpty().flatMap { enabled -> split(enabled, autonomous) }.flatMap { piece ->
        if (piece.isInside) {
            listOf(EnabledSpan(piece.span, isAutonomous = true, opMode = names?.at(piece.span.from)))
        } else {
            split(piece.span, tests).map { EnabledSpan(it.span, isAutonomous = false, it.isInside, names?.at(it.span.from)) }
        }
    }
}

/** Whether the recording shows when the robot was enabled; if not, [enabledSpans] is empty even if the robot was enabled. */
public val LogView.knowsEnabled: Boolean get() = modes.enabled?.let { topicOf(it.topic) }?.let { seriesOf(it).data.isOrdered } ?: false

/** Whether the recording shows which [enabledSpans] were autonomous. */
public val LogView.knowsAutonomous: Boolean get() = knowsEnabled && modes.autonomous?.let { topicOf(it.topic) } != null

/** Returns the topics that decide where [enabledSpans] begin and end. */
public fun LogView.enabledTopics(): List<Topic> =
    listOfNotNull(modes.enabled, modes.autonomous, modes.test).mapNotNull { topicOf(it.topic) }.distinct()

private fun LogView.topicOf(name: String) = recording.topics.find { it.name == name && seriesOf(it).data.size > 0 }

private fun LogView.spansOf(flag: FlagTopic): List<Span> {
    val topic = topicOf(flag.topic) ?: return emptyList()
    val line = seriesOf(topic)
    val series = line.data
    if (!series.isOrdered) return emptyList()
    val states = line.states.orEmpty()
    val flags = Series(series.x, DoubleArray(series.size) { if (flag.reading.isSet(series.y[it], states)) 1.0 else 0.0 })
    val end = if (line.holds || topic.isSparse) xAxis.range?.endInclusive else null
    val runs = StateRuns(flags, end ?: series.x.last())
    return runs.states.indices.filter { runs.states[it] == 1 }.map { Span(runs.from[it], runs.to[it]) }
}

/** The texts of a topic over x. */
private class Texts(private val series: Series, private val texts: List<String>) {
    /** Returns the text that holds at [x]; null if it is empty, or if [x] is before the first text. */
    fun at(x: Double): String? {
        val last = series.firstAfter(x) - 1
        val sample = if (last < 0) Double.NaN else series.y[last]
        return if (sample.isNaN()) null else texts.getOrNull(sample.toInt())?.trim()?.takeIf { it.isNotEmpty() }
    }
}

private fun LogView.textsOf(name: String): Texts? {
    val line = topicOf(name)?.let(::seriesOf) ?: return null
    return line.states?.takeIf { line.data.isOrdered }?.let { Texts(line.data, it) }
}

/** A piece of a span, and whether it lies inside other spans. */
private class SplitPiece(val span: Span, val isInside: Boolean)

/** Cuts [whole] where [others] begin and end. */
private fun split(whole: Span, others: List<Span>): List<SplitPiece> {
    val pieces = ArrayList<SplitPiece>()
    var at = whole.from
    for (other in others) {
        val from = maxOf(other.from, at)
        val to = minOf(other.to, whole.to)
        if (to <= from) continue
        if (from > at) pieces += SplitPiece(Span(at, from), false)
        pieces += SplitPiece(Span(from, to), true)
        at = to
    }
    if (whole.to > at || pieces.isEmpty()) pieces += SplitPiece(Span(at, whole.to), false)
    return pieces
}
