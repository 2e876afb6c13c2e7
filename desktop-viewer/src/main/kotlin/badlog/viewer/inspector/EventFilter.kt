package badlog.viewer.inspector

/**
 * Which events are listed and marked.
 *
 * @property text words that the text or the topic of an event must contain, regardless of case; empty for any.
 * @property topics the names of the topics whose events count; empty for all.
 */
internal data class EventFilter(val text: String = "", val topics: Set<String> = emptySet()) {
    /** Whether it lets everything through. */
    val isOff: Boolean get() = text.isBlank() && topics.isEmpty()

    /** Adds [topic] to [topics], or takes it out. */
    fun toggled(topic: String): EventFilter = copy(topics = if (topic in topics) topics - topic else topics + topic)
}
