package badlog.cli.merge

/** How logs become one. */
internal enum class MergeMode {
    /** Those with the same topics one after the other, then those with different ones side by side. */
    BY_TOPICS,

    /** All one after the other; topics that one lacks are empty there. */
    APPEND,

    /** All side by side. */
    JOIN,
    ;

    /** Which of [parts] follow each other; those of different lists stand side by side. */
    fun groupsOf(parts: List<LogPart>): List<List<LogPart>> = when (this) {
        APPEND -> listOf(parts)
        JOIN -> parts.map(::listOf)
        BY_TOPICS -> parts.groupBy { part -> part.recording.topics.mapTo(HashSet()) { it.name } }.values.toList()
    }
}
