package badlog.signals

import badlog.core.analysis.LogView
import badlog.expression.LogViewSignals
import badlog.expression.signals.Vocabulary
import badlog.signals.pose.PlannedPath
import badlog.signals.pose.SeenPath
import badlog.signals.pose.posesOf
import badlog.signals.vocabulary.SignalTopics
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.vocabulary.topicsWithoutValues

/**
 * The properties of a log that decide how rules are prepared for it. Logs with equal shapes share a program of the rules.
 *
 * @property vocabulary the names of the topics.
 * @property timeTopic the topic of the x axis, or null.
 * @property hasClock whether x is time, although no topic has it.
 * @property empty the names of the [topics that say nothing][topicsWithoutValues], which are not signals.
 * @property path the driven path and the planned one; null for none.
 * @property sight the driven path and where a camera saw the robot; null for none.
 */
data class LogShape(
    val vocabulary: Vocabulary,
    val timeTopic: String?,
    val hasClock: Boolean,
    val empty: Set<String> = emptySet(),
    val path: PlannedPath? = null,
    val sight: SeenPath? = null,
) {
    /** Returns which of the topics are the signals of [signals]. */
    fun topicsOf(signals: SignalVocabulary): SignalTopics = SignalTopics(signals, vocabulary, timeTopic, empty)

    companion object {
        /** Returns the shape of [view], which needs no samples. */
        fun of(view: LogView): LogShape {
            val x = view.xAxis
            val empty = topicsWithoutValues(view.recording.topics)
            val poses = posesOf(view.recording.topics)
            return LogShape(
                LogViewSignals(view).vocabulary,
                x.topic?.name,
                hasClock = x.topic == null && !x.isIndex,
                empty,
                PlannedPath.of(poses),
                SeenPath.of(poses),
            )
        }
    }
}
