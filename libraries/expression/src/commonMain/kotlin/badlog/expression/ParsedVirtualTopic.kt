package badlog.expression

/** What became of a definition: a [VirtualTopic], or the [ExpressionError] that says why not. */
public sealed interface ParsedVirtualTopic
