package badlog.signals.match

/** The kind of run in which a log was recorded. Logs of the same kind are compared. */
enum class MatchKind {
    /** A match that counts. */
    MATCH,

    /** Practice, or a test. */
    PRACTICE,

    /** The log does not say, or names a type that is not known. */
    UNKNOWN,
}
