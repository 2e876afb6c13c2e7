package badlog.expression

/** What the answer to a question is. */
public enum class Outcome {
    /** Yes: it holds, or does at some time. */
    HOLDS,

    /** No. */
    FAILS,

    /** Not known, since samples are missing that would tell. */
    UNKNOWN,

    /** The expression was no question but a number; see [Answer.figures]. */
    NO_QUESTION,
}
