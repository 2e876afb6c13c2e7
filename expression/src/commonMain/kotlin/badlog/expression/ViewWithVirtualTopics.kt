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
    val errors = ArrayList<ExpressionError>()
    val topics = ArrayList<VirtualTopic>()
    var signals: Signals = LogViewSignals(this)
    for (definition in definitions) {
        when (val parsed = VirtualTopic.parse(definition, signals.vocabulary)) {
            is ExpressionError -> errors += parsed
            is VirtualTopic -> {
                topics += parsed
                signals = signals.with(parsed)
            }
        }
    }
    if (topics.isEmpty()) return ViewWithVirtualTopics(this, topics, errors)
    val extended = recording.run {
        val added = topics.map { calculatedTopic(it, signals.series(it.name), xAxis) }
        Recording(format, headerLine, values, this.topics + added, rowCount, problems)
    }
    return ViewWithVirtualTopics(LogView.of(extended), topics, errors)
}
