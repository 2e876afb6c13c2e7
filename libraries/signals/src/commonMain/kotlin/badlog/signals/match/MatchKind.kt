package badlog.signals.match

/** The kind of run that a log is of: logs of the same kind are compared. */
enum class MatchKind {
    /** A match that counts. */
    MATCH,

    /** Practice, or a test. */
    PRACTICE,

    /** The log does not say, or names a type that is not known. */
    UNKNOWN,
}
