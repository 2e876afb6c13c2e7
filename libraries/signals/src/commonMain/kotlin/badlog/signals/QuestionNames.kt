package badlog.signals

import badlog.core.analysis.LogView
import badlog.expression.LogViewSignals
import badlog.expression.signals.Vocabulary
import badlog.signals.vocabulary.SignalVocabulary

/**
 * The names that questions can use in logs of the shape [shape]. They are its topics, and the signals of [signals] without a topic of the same name.
 * Thread-safe.
 */
class QuestionNames(signals: SignalVocabulary, shape: LogShape) {
    private val named = LinkedHashMap<String, NamedSignal>()
    private val several = LinkedHashMap<String, List<String>>()

    private val topics = shape.topicsOf(signals)

    init {
        for (signal in signals.signals) {
            if (shape.vocabulary.knows(signal.name)) continue
            val found = topics.of(signal.name).ifEmpty { topics.summandsOf(signal.name) }
            if (signal.isMany && found.size > 1) several[signal.name] = found.map { it.topic }
            if (found.isNotEmpty() && signal.name !in several) named[signal.name] = NamedSignal.of(signal.name, found)
        }
    }

    val vocabulary: Vocabulary = shape.vocabulary.let {
        val meanings = signals.signals.map { signal -> signal.name }.filter { name -> name !in several && !it.knows(name) }
        Vocabulary(it.signals + named.values.map { signal -> signal.listed }, it.hasTime, meanings.toSet(), several = several)
    }

    /** Returns the samples of [view], which must have this shape, under these names. */
    fun signalsOf(view: LogView): NamedSignals {
        val known = view.identified(view.title, topics.modes)
        val log = LogViewSignals(known)
        return NamedSignals(log, named, vocabulary, NamedSamples(log, known))
    }
}
