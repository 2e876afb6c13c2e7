package badlog.expression

/** What became of a text: an [Expression], or the [ExpressionError] that says why not. */
public sealed interface ParsedExpression
