package badlog.expression.syntax

/** Returns the text of [node]; reading it gives the same expression. It has full names in quotes, and parentheses only where necessary. */
internal fun printed(node: Node): String = when (node) {
    is Node.Number -> node.digits

    is Node.Time -> node.written

    is Node.Truth -> node.value.toString()

    is Node.Text -> quoted(node.text, '\'')

    is Node.Topic -> quoted(node.signal.name, '"')

    is Node.Enabled -> node.mode.word

    is Node.Axis -> AXIS

    is Node.Measured -> "${node.digits} ${node.unit}"

    is Node.Negative -> "-" + printed(node.operand, Precedence.POWER)

    is Node.Not -> "not " + printed(node.operand, Precedence.NOT)

    is Node.For -> "${printed(node.condition, Precedence.FOR)} for ${printed(node.time)}"

    is Node.Binary -> {
        val own = node.operator.precedence
        val isPower = node.operator == Operator.POWER
        val leftLeast = if (isPower || node.operator.isComparison) own + 1 else own
        val rightLeast = if (isPower) own else own + 1
        "${printed(node.left, leftLeast)} ${node.operator.symbol} ${printed(node.right, rightLeast)}"
    }

    is Node.Call -> node.arguments.joinToString(", ", "${node.function.title}(", ")") { printed(it) }
}

private fun printed(node: Node, least: Int): String = if (precedenceOf(node) < least) "(${printed(node)})" else printed(node)

private fun precedenceOf(node: Node): Int = when (node) {
    is Node.Binary -> node.operator.precedence
    is Node.For -> Precedence.FOR
    is Node.Not -> Precedence.NOT
    is Node.Negative -> Precedence.NEGATIVE
    is Node.Time -> if (node.seconds < 0) Precedence.NEGATIVE else Precedence.OPERAND
    else -> Precedence.OPERAND
}

private fun quoted(text: String, quote: Char): String = quote + text.replace("$quote", "$quote$quote") + quote
