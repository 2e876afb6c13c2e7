package badlog.expression.checking

import badlog.expression.signals.SignalKind
import badlog.expression.syntax.Function
import badlog.expression.syntax.Kind
import badlog.expression.syntax.Node
import badlog.expression.syntax.Operator
import badlog.expression.syntax.Parameter
import badlog.expression.syntax.Type
import badlog.expression.syntax.mistake

/** Determines the type of each node; fails at the first node that does not fit. */
internal object Checker {
    /** Checks [node], assigns ids to it and all nodes below it from [firstId] on, and returns the next free id. */
    fun check(node: Node, firstId: Int = 0): Int {
        var id = firstId
        for (child in node.children) id = check(child, id)
        node.id = id
        node.type = typeOf(node).copy(isMomentary = isMomentary(node))
        return id + 1
    }

    private fun isMomentary(node: Node): Boolean {
        if (node is Node.Topic) return node.signal.kind == SignalKind.EVENT
        if (node is Node.Call && node.function.timing != Function.Timing.AS_OPERANDS) {
            return node.function.timing == Function.Timing.AT_MOMENTS
        }
        val varying = node.children.filter { it.type.isOverTime }
        val isEither = (node is Node.Binary && node.operator == Operator.OR) || (node is Node.Call && node.function == Function.IF)
        return if (isEither) varying.isNotEmpty() && varying.all { it.type.isMomentary } else varying.any { it.type.isMomentary }
    }

    private fun typeOf(node: Node): Type = when (node) {
        is Node.Number, is Node.Measured -> Type(Kind.NUMBER, false)
        is Node.Time -> Type(Kind.TIME, false)
        is Node.Truth -> Type(Kind.CONDITION, false)
        is Node.Text -> Type(Kind.TEXT, false)
        is Node.Topic -> Type(kindOf(node.signal.kind), true)
        is Node.Enabled -> Type(Kind.CONDITION, true)
        is Node.Axis -> Type(Kind.NUMBER, true)
        is Node.Negative -> Type(Kind.NUMBER, needNumber(node.operand).isOverTime)
        is Node.Not -> Type(Kind.CONDITION, needCondition(node.operand).isOverTime)
        is Node.For -> typeOfFor(node)
        is Node.Binary -> typeOfBinary(node)
        is Node.Call -> typeOfCall(node)
    }

    private fun kindOf(kind: SignalKind) = when (kind) {
        SignalKind.NUMBER -> Kind.NUMBER
        SignalKind.CONDITION -> Kind.CONDITION
        SignalKind.STATE, SignalKind.EVENT -> Kind.TEXT
    }

    private fun typeOfFor(node: Node.For): Type {
        if (!needCondition(node.condition).isOverTime) {
            mistake(node.condition, "“for” needs a condition that changes over time before it.")
        }
        requireLasting(node.condition)
        if (node.time.seconds <= 0) mistake(node.time, "“for” needs a time above 0 after it.")
        return node.condition.type
    }

    private fun typeOfBinary(node: Node.Binary): Type {
        val left = node.left.type
        val right = node.right.type
        val isOverTime = left.isOverTime || right.isOverTime
        return when (node.operator.group) {
            Operator.Group.WHEN -> {
                needCondition(node.right)
                if (left.kind == Kind.TEXT && !left.isOverTime) mistake(node.left, "A fixed text cannot have “when”.")
                if (!left.isOverTime) summaryIn(node.left)?.let { mistake(it, inside(it.function.title)) }
                Type(if (left.kind == Kind.TIME) Kind.NUMBER else left.kind, isOverTime)
            }

            Operator.Group.LOGIC -> {
                needCondition(node.left)
                needCondition(node.right)
                Type(Kind.CONDITION, isOverTime)
            }

            Operator.Group.TEXT -> {
                val symbol = node.operator.symbol
                if (left.kind != Kind.TEXT || !left.isOverTime) {
                    mistake(node.left, "“$symbol” needs a topic of texts before it, not ${described(node.left)}.")
                }
                if (node.right !is Node.Text) mistake(node.right, "“$symbol” needs a text in single quotes after it.")
                Type(Kind.CONDITION, true)
            }

            Operator.Group.ORDER -> {
                needNumber(node.left)
                needNumber(node.right)
                Type(Kind.CONDITION, isOverTime)
            }

            Operator.Group.EQUALITY -> {
                if ((left.kind == Kind.TEXT) != (right.kind == Kind.TEXT)) {
                    val text = if (left.kind == Kind.TEXT) node.left else node.right
                    val other = if (left.kind == Kind.TEXT) node.right else node.left
                    val hint = if (other is Node.Topic) "" else "; put texts in single quotes"
                    mistake(node, "A text, ${quotedPart(text)}, cannot be compared with ${described(other)}$hint.")
                }
                if (left.kind == Kind.TEXT && !isOverTime) mistake(node, "Two fixed texts need no comparison; compare a topic with a text.")
                Type(Kind.CONDITION, isOverTime)
            }

            Operator.Group.ARITHMETIC -> {
                needNumber(node.left)
                needNumber(node.right)
                Type(Kind.NUMBER, isOverTime)
            }
        }
    }

    private fun typeOfCall(node: Node.Call): Type {
        val function = node.function
        for ((index, argument) in node.arguments.withIndex()) {
            val parameter = function.parameters[index]
            if (!parameter.accepts(argument)) {
                val comparesTwo = parameter == Parameter.WINDOW && argument.type.isOverTime && argument.type.kind.isNumeric
                val hint = if (comparesTwo) "; to choose between two, use if(a < b, a, b)" else ""
                mistake(argument, "${function.title} needs ${parameter.needed}, not ${described(argument)}$hint.")
            }
        }
        val arguments = node.arguments
        if (function.needsLasting) requireLasting(arguments[0])
        val isOverTime = arguments.any { it.type.isOverTime }
        return when (function.result) {
            Function.Result.NUMBER -> Type(Kind.NUMBER, false)

            Function.Result.CONDITION -> Type(Kind.CONDITION, false)

            Function.Result.NUMBERS -> Type(Kind.NUMBER, true)

            Function.Result.CONDITIONS -> Type(Kind.CONDITION, true)

            Function.Result.ELEMENTWISE -> Type(Kind.NUMBER, isOverTime)

            Function.Result.AS_FIRST -> arguments[0].type

            Function.Result.AS_CHOSEN -> {
                val areConditions = arguments.drop(1).all { it.type.kind == Kind.CONDITION }
                Type(if (areConditions) Kind.CONDITION else Kind.NUMBER, isOverTime)
            }
        }
    }

    private fun needNumber(node: Node): Type {
        if (!node.type.kind.isNumeric) mistake(node, "A number is needed here, not ${described(node)}.")
        return node.type
    }

    private fun needCondition(node: Node): Type {
        if (node.type.kind != Kind.CONDITION) {
            val example = if (node.type.kind == Kind.TEXT) "== 'IDLE'" else "> 0"
            val what = "${if (node is Node.Topic) "“${node.signal.name}”" else "this"} is ${node.type.kind.title}"
            mistake(node, "A condition is needed here, but $what; compare it, as in x $example.")
        }
        return node.type
    }

    private fun requireLasting(node: Node) {
        if (!node.type.isMomentary) return
        mistake(node, "A moment has no duration; count(c) counts moments, and hold(x) keeps the text of an event until the next.")
    }

    /** Returns the first function over the whole recording in [node]. */
    private fun summaryIn(node: Node): Node.Call? =
        if (node is Node.Call && node.arguments.any { it.type.isOverTime }) node else node.children.firstNotNullOfOrNull(::summaryIn)

    private fun inside(title: String) = "$title covers the whole log, so “when” has no effect; put it inside: $title(x when c)."

    private fun described(node: Node): String {
        val kind = node.type.kind.title
        return when {
            node is Node.Topic -> "“${node.signal.name}”, which is $kind"
            node.type.isOverTime -> "$kind over time"
            else -> kind
        }
    }

    private fun quotedPart(node: Node): String = when (node) {
        is Node.Topic -> "“${node.signal.name}”"
        is Node.Text -> "'${node.text}'"
        else -> "as here"
    }
}
