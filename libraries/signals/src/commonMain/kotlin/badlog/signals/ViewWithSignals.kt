package badlog.signals

import badlog.core.analysis.LogView
import badlog.expression.ViewWithVirtualTopics
import badlog.expression.VirtualTopicsDraft
import badlog.expression.signals.Signals
import badlog.expression.withVirtualTopics
import badlog.signals.match.matchOf
import badlog.signals.vocabulary.SignalTopics
import badlog.signals.vocabulary.SignalVocabulary

/**
 * Returns this view with its match and the times when the robot was enabled. [vocabulary] finds them, whatever the names of its topics.
 *
 * @param fileName the name of the log's file, which may show the match.
 */
fun LogView.withSignals(vocabulary: SignalVocabulary, fileName: String): LogView =
    identified(vocabulary.matchOf(recording, fileName).title, signalTopicsOf(this, vocabulary).modes)

/** Returns the names that questions and formulas can use in this view: its topics, and the signals of [vocabulary]. */
fun LogView.namesWith(vocabulary: SignalVocabulary): Signals = QuestionNames(vocabulary, LogShape.of(this)).signalsOf(this)

/** Returns this view with a topic for each of [definitions], which may name the signals of [vocabulary]. */
fun LogView.withVirtualTopics(definitions: List<String>, vocabulary: SignalVocabulary): ViewWithVirtualTopics =
    if (definitions.isEmpty()) withVirtualTopics(definitions) else withVirtualTopics(definitions, namesWith(vocabulary))

/** Returns a draft of the same view, to be built step by step; see [VirtualTopicsDraft]. */
fun LogView.beginVirtualTopics(definitions: List<String>, vocabulary: SignalVocabulary): VirtualTopicsDraft =
    VirtualTopicsDraft(this, definitions, namesWith(vocabulary))

/** Returns the topics of [view] that are the signals of [vocabulary]; needs no samples. */
fun signalTopicsOf(view: LogView, vocabulary: SignalVocabulary): SignalTopics = LogShape.of(view).topicsOf(vocabulary)
