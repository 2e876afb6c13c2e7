package badlog.viewer.graph

import badlog.recording.Topic

/** Whether [topic] has two values that differ. */
internal fun everChanges(topic: Topic): Boolean {
    val first = topic.samples.firstOrNull { !it.isNaN() }
    return topic.texts.dictionary.size > 1 || (first != null && topic.samples.any { !it.isNaN() && it != first })
}
