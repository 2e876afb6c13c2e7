package badlog.expression

import badlog.analysis.LogView
import badlog.recording.Recording

/**
 * A view whose topics are also virtual ones.
 *
 * @property view the recording with a topic for each of [topics] after its own, shown in graphs as they are.
 * @property topics the virtual topics, in the order of their definitions.
 * @property errors why other definitions make none here, in their order.
 */
public class ViewWithVirtualTopics internal constructor(
    public val view: LogView,
    public val topics: List<VirtualTopic>,
    public val errors: List<ExpressionError>,
)

/**
 * This view with a topic for each of [definitions], see [VirtualTopic.parse]; each may use those before it. What fails is told
 * and costs the others nothing.
 *
 * The new topics have as [metadata][badlog.recording.Topic.metadata] what they are calculated by. Those of recordings with rows
 * share the rows where they have a sample in each.
 */
public fun LogView.withVirtualTopics(definitions: List<String>): ViewWithVirtualTopics {
    val defined = DefinedTopics(this, definitions)
    if (defined.topics.isEmpty()) return ViewWithVirtualTopics(this, emptyList(), defined.errors)
    val extended = recording.run {
        val added = defined.topics.map { calculatedTopic(it, defined.signals.series(it.name), xAxis, defined.signals.stretches) }
        Recording(format, headerLine, values, topics + added, rowCount, problems)
    }
    return ViewWithVirtualTopics(LogView.of(extended), defined.topics, defined.errors)
}

/** Why some of [definitions] make no topic in [view], in their order. Calculates nothing, so [view] needs no samples. */
public fun undefinedTopics(view: LogView, definitions: List<String>): List<ExpressionError> = DefinedTopics(view, definitions).errors

private class DefinedTopics(view: LogView, definitions: List<String>) {
    val topics = ArrayList<VirtualTopic>()
    val errors = ArrayList<ExpressionError>()
    var signals: Signals = LogViewSignals(view)
        private set

    init {
        for (definition in definitions) {
            when (val parsed = VirtualTopic.parse(definition, signals.vocabulary)) {
                is ExpressionError -> errors += parsed

                is VirtualTopic -> {
                    topics += parsed
                    signals = signals.with(parsed)
                }
            }
        }
    }
}
