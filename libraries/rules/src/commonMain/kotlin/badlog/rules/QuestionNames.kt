package badlog.rules

import badlog.analysis.LogView
import badlog.expression.LogViewSignals
import badlog.expression.signals.Signals
import badlog.expression.signals.Vocabulary
import badlog.rules.signal.SignalTopics
import badlog.rules.signal.SignalVocabulary

/**
 * What questions may name in logs of the shape [shape]: their topics, and the signals of [signals] whose names mean no topic there.
 * Safe for several threads.
 */
public class QuestionNames(signals: SignalVocabulary, shape: LogShape) {
    private val named = LinkedHashMap<String, NamedSignal>()

    init {
        val topics = SignalTopics(signals, shape.vocabulary, shape.timeTopic)
        for (signal in signals.signals) {
            if (signal.isMany || shape.vocabulary.knows(signal.name)) continue
            val found = topics.of(signal.name).ifEmpty { topics.summandsOf(signal.name) }
            if (found.isNotEmpty()) named[signal.name] = NamedSignal.of(signal.name, found)
        }
    }

    /** The names. */
    public val vocabulary: Vocabulary =
        shape.vocabulary.let { Vocabulary(it.signals + named.values.map { signal -> signal.listed }, it.hasTime) }

    /** The samples of [view], which is of the shape, under these names. */
    public fun signalsOf(view: LogView): Signals {
        val log = LogViewSignals(view)
        return NamedSignals(log, named, vocabulary, NamedSamples(log, view))
    }
}

/** Which topics of [view] are the signals of [vocabulary]; needs no samples. */
public fun signalTopicsOf(view: LogView, vocabulary: SignalVocabulary): SignalTopics =
    LogShape.of(view).let { SignalTopics(vocabulary, it.vocabulary, it.timeTopic) }
