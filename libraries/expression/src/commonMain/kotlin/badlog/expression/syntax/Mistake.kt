package badlog.expression.syntax

/** Thrown inside the parser at the first mistake; never leaves the parser. */
internal class Mistake(val from: Int, val until: Int, val kind: ExpressionErrorKind, override val message: String) : Exception(message)

internal fun mistake(node: Node, message: String): Nothing = throw Mistake(node.from, node.until, ExpressionErrorKind.TYPE, message)

/** The words that introduce suggested replacements for an unknown name. */
internal const val SUGGESTION = "Did you mean "

/** The kinds of mistakes that an [badlog.expression.ExpressionError] reports. */
enum class ExpressionErrorKind {
    /** It cannot be read as an expression. */
    SYNTAX,

    /** It names a topic that this recording does not have; another recording may have it. */
    UNKNOWN_TOPIC,

    /** It names a topic by the end of its path, but several topics share that end. */
    AMBIGUOUS_TOPIC,

    /** It has a time, such as `0.5 s`, but this recording's x is not a time; another recording's may be. */
    NO_TIME,

    /** It uses something where something else is needed, such as a number as a condition. */
    TYPE,

    /** It is longer, more deeply nested or more expensive than allowed. */
    LIMIT,
}
