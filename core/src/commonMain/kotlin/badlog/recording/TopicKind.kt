package badlog.recording

/** What the cells of a [Topic] turned out to be. */
public enum class TopicKind {
    /** No cell holds anything. */
    EMPTY,

    /** Numbers. */
    NUMERIC,

    /** Only `true` and `false`, kept as 1 and 0. */
    BOOLEAN,

    /** Mostly texts, in at least half of the rows: what state something is in. */
    STATE,

    /** Mostly texts, in fewer than half of the rows: what happened. */
    EVENT,
}
