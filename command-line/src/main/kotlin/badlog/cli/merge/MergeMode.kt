package badlog.cli.merge

/** How logs become one. */
internal enum class MergeMode {
    /** Those with the same topics one after the other, then those with different ones side by side. */
    BY_TOPICS,

    /** All one after the other; topics that one lacks are empty there. */
    APPEND,

    /** All side by side. */
    JOIN,
}
