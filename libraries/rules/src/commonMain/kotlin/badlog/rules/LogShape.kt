package badlog.rules

import badlog.analysis.LogView
import badlog.expression.LogViewSignals
import badlog.expression.signals.Vocabulary
import badlog.recording.TopicKind
import badlog.rules.path.PlannedPath
import badlog.rules.path.posesOf
import badlog.rules.signal.SignalTopics
import badlog.rules.signal.SignalVocabulary

/**
 * What decides how rules are prepared for a log. Logs with equal shapes share a [RuleProgram].
 *
 * @property vocabulary the names of the topics.
 * @property timeTopic the topic of the x axis, or null.
 * @property hasClock whether x is time, although no topic has it.
 * @property empty the names of the topics without samples, which are not signals.
 * @property path the driven path and the planned one; null for none.
 */
public data class LogShape(
    public val vocabulary: Vocabulary,
    public val timeTopic: String?,
    public val hasClock: Boolean,
    public val empty: Set<String> = emptySet(),
    public val path: PlannedPath? = null,
) {
    /** Returns which of the topics are the signals of [signals]. */
    public fun topicsOf(signals: SignalVocabulary): SignalTopics = SignalTopics(signals, vocabulary, timeTopic, empty)

    public companion object {
        /** Returns the shape of [view], which needs no samples. */
        public fun of(view: LogView): LogShape {
            val x = view.xAxis
            val empty = view.recording.topics.filter { it.kind == TopicKind.EMPTY }.mapTo(HashSet()) { it.name }
            return LogShape(
                LogViewSignals(view).vocabulary,
                x.topic?.name,
                hasClock = x.topic == null && !x.isIndex,
                empty,
                PlannedPath.of(posesOf(view.recording.topics)),
            )
        }
    }
}
