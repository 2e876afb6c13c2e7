package badlog.signals

import badlog.core.analysis.LogView
import badlog.core.recording.TopicKind
import badlog.signals.vocabulary.NamePattern
import badlog.signals.vocabulary.SignalContent
import badlog.signals.vocabulary.SignalName
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.vocabulary.TopicPattern

/** Returns this vocabulary with [topic] as the first name of the signal [signal]. */
fun SignalVocabulary.assigning(signal: String, topic: String): SignalVocabulary {
    val topics = listOf(TopicPattern(NamePattern(topic), unit = null))
    val content = find(signal)?.content ?: SignalContent.NUMBER
    val own = SignalName(signal, meaning = "", content, unit = null, topics, except = emptyList(), isMany = false, sumOf = null)
    return with(SignalVocabulary(listOf(own), emptyList(), emptyList()))
}

/**
 * Returns why [topic] of [view] cannot be the signal [signal], as a sentence; null if it is that signal. In [vocabulary], the topic is the
 * signal's first name.
 */
fun refusalOf(signal: String, topic: String, view: LogView, vocabulary: SignalVocabulary): String? {
    if (signalTopicsOf(view, vocabulary).of(signal).any { it.topic == topic }) return null
    val recorded = view.recording.topics.find { it.name == topic } ?: return "“$topic” is not a topic of this log; choose another one."
    if (recorded.kind == TopicKind.EMPTY) return "“$topic” has no samples in this log; choose another topic."
    val known = vocabulary.find(signal)
    val what = known?.content?.name?.lowercase() + known?.unit?.let { " in $it" }.orEmpty()
    return "“$topic” cannot be “$signal”, which is a $what; choose another topic."
}
