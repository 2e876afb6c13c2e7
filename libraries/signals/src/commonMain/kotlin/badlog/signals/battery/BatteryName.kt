package badlog.signals.battery

import badlog.core.analysis.firstText
import badlog.core.analysis.isMeaningful
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.signals.vocabulary.BATTERY_NAME
import badlog.signals.vocabulary.NamePattern
import badlog.signals.vocabulary.SignalVocabulary

/**
 * Returns the name of the battery in [recording]. It is a value of the header, otherwise the last sample of a topic; null if the recording
 * has neither. [vocabulary] has the names of both.
 */
fun batteryNameIn(recording: Recording, vocabulary: SignalVocabulary): String? {
    val patterns = vocabulary.find(BATTERY_NAME)?.topics.orEmpty().map { it.pattern }
    fun isNamed(name: String) = NamePattern.folded(name).let { folded -> patterns.any { it.matchesFolded(folded) } }
    val found = recording.values.firstOrNull { isMeaningful(it.text) && isNamed(it.name) }?.text
        ?: recording.values.firstText("battery")?.takeIf(::isName)
        ?: recording.topics.firstNotNullOfOrNull { topic -> if (isNamed(topic.name)) lastIn(topic) else null }
    return found?.trim()?.take(LONGEST)
}

// A value with this name may be a voltage.
private fun isName(text: String) = text.trim().lowercase().removeSuffix("volts").trimEnd('v', ' ').toDoubleOrNull() == null

private fun lastIn(topic: Topic): String? {
    val texts = topic.texts
    for (i in texts.size - 1 downTo 0) if (isMeaningful(texts[i])) return texts[i]
    if (topic.type == "boolean") return null
    return topic.samples.lastOrNull { it >= 1 && it == it.toInt().toDouble() }?.toInt()?.toString()
}

/** More letters than on any label. */
private const val LONGEST = 60
