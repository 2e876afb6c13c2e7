package badlog.expression

/** Leaves the parser at the first mistake; never seen outside of it. */
internal class Mistake(val from: Int, val until: Int, val kind: ExpressionErrorKind, override val message: String) : Exception(message)

internal fun mistake(node: Node, message: String): Nothing = throw Mistake(node.from, node.until, ExpressionErrorKind.TYPE, message)
