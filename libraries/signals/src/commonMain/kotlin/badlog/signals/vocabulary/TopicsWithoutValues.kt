package badlog.signals.vocabulary

import badlog.core.recording.Topic
import badlog.core.recording.TopicKind

/**
 * Returns the names of [topics] without information. They have no samples, or only sizes, or a single value of a NetworkTables topic that is
 * logged again without the prefix `NT:`, and changes there.
 */
internal fun topicsWithoutValues(topics: List<Topic>): Set<String> {
    val byName = topics.associateBy { it.name }
    fun values(topic: Topic) = topic.size - topic.counts.empty

    fun isRepeated(topic: Topic): Boolean {
        val twin = byName[topic.name.removePrefix(NT_PREFIX)]
        return twin != null && twin !== topic && values(topic) <= 1 && values(twin) > 1
    }
    return topics.filter { it.kind == TopicKind.EMPTY || it.isSizes || isRepeated(it) }.mapTo(HashSet()) { it.name }
}

private const val NT_PREFIX = "NT:"
