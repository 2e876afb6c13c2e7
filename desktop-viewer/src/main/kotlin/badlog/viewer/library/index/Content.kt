package badlog.viewer.library.index

/**
 * Whether there is anything to see in a file.
 *
 * @property saying what stands beside a log that is greyed; empty for one that is not.
 */
internal enum class Content(val saying: String) {
    /** There is. */
    SOMETHING(""),

    /** It has none. */
    NO_SAMPLES("no samples"),

    /** No number changes and nothing is told. */
    NOTHING_CHANGES("nothing happened here"),

    /** It is over before anything can have happened. */
    TOO_SHORT("shorter than a second"),

    /** The robot was off duty all the time, and it was no match: in a match, that it never moved is the story. */
    NEVER_ENABLED("never enabled"),

    /** It cannot be read though its name says that it is a log. */
    UNREADABLE("cannot be read"),

    /** Something else that only shares its ending with logs, such as a spreadsheet of texts; it is not listed. */
    NO_LOG(""),
}
