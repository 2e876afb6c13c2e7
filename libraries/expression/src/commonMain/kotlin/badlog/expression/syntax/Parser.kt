package badlog.expression.syntax

import badlog.core.text.isLetter
import badlog.expression.signals.MAX_EXPRESSION_LENGTH
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Vocabulary

/**
 * Reads an expression by the precedence of its operators (Pratt 1973). Written by hand, because names depend on the vocabulary and on where
 * operands are allowed, which a table of tokens cannot express.
 */
internal class Parser(private val text: String, private val vocabulary: Vocabulary) {
    private val scanner = Scanner(text)
    private val names = NameReader(text, scanner, vocabulary)
    private var nodes = 0
    private var moves = 0

    // The position of the last topic that was read without quotes.
    private var plainNameFrom = -1
    private var plainNameUntil = -1

    fun parse(): Node {
        if (text.length > Limits.LENGTH) {
            fail(Limits.LENGTH, text.length, "An expression has at most ${Limits.LENGTH} characters.", ExpressionErrorKind.LIMIT)
        }
        val node = expression(Precedence.WHEN, 0)
        if (!scanner.isAtEnd()) failAtUnexpected()
        return node
    }

    private fun expression(least: Int, nesting: Int): Node {
        if (nesting > Limits.NESTING) failTooDeep(scanner.at, scanner.at)
        var left = operand(nesting)
        while (true) {
            scanner.skipSpace()
            val operatorFrom = scanner.at
            if (least <= Precedence.FOR && scanner.takeWord("for")) {
                left = made(Node.For(left, readTime(operatorFrom)))
                continue
            }
            if (least <= Precedence.FOR && scanner.takeWord("within")) {
                left = made(readNearness(left, operatorFrom, nesting))
                continue
            }
            val spelling = scanner.peekOperator() ?: return left
            val operator = spelling.second
            if (operator.precedence < least) return left
            if (operator.isComparison && left is Node.Binary && left.operator.isComparison && !isInParentheses(left)) {
                fail(operatorFrom, operatorFrom + spelling.first.length, CHAINED)
            }
            if (operator == Operator.DIVIDED_BY) requireNoPath(operatorFrom)
            scanner.at += spelling.first.length
            val operatorUntil = scanner.at
            if (operator == Operator.REMAINDER && left is Node.Number && isOperandMissing()) {
                left = made(Node.Measured(left.from, operatorUntil, left.value, left.digits, "%"))
                continue
            }
            // Except for ^, an operator of the same precedence begins the next round.
            val right = try {
                expression(operator.precedence + if (operator == Operator.POWER) 0 else 1, nesting + 1)
            } catch (mistake: Mistake) {
                throw if (isOfText(left, operator) && mistake.kind == ExpressionErrorKind.UNKNOWN_TOPIC) asText(mistake) else mistake
            }
            left = made(Node.Binary(operator, left, right))
        }
    }

    /** Fails if the division is written like a path, such as `Arm/Angle`, and is not a topic's name. */
    private fun requireNoPath(slash: Int) {
        val isPath = plainNameUntil == slash && slash + 1 < text.length && (isLetter(text[slash + 1]) || text[slash + 1] == '_')
        if (isPath && !names.isCallAt(slash + 1)) names.failPath(plainNameFrom)
    }

    private fun isOperandMissing(): Boolean {
        if (scanner.isAtEnd() || text[scanner.at] in "),") return true
        val next = scanner.peekOperator()?.second
        return (next != null && next != Operator.MINUS) || scanner.restWord().equals("for", ignoreCase = true)
    }

    private fun isOfText(left: Node, operator: Operator) = operator.group == Operator.Group.TEXT ||
        (operator.group == Operator.Group.EQUALITY && left is Node.Topic && left.signal.kind in TEXTS)

    private fun asText(mistake: Mistake): Mistake = mistake.run {
        val name = text.substring(from, until).trim('"', '`')
        Mistake(from, until, kind, "${names.unknownNameText(name)}; put a text in single quotes, as in '$name'.")
    }

    // An operand in parentheses extends beyond its parts.
    private fun isInParentheses(node: Node) = node.from < node.children.first().from

    private fun readTime(wordFrom: Int): Node.Time {
        val word = text.substring(wordFrom, scanner.at)
        val message = "“$word” needs a time after it, as in $word 0.5 s."
        scanner.skipSpace()
        val from = scanner.at
        if (!scanner.isNumberHere()) fail(wordFrom, wordFrom + word.length, message)
        return number() as? Node.Time ?: fail(from, scanner.at, message)
    }

    /** Reads the text after the word “within” at [wordFrom]. For example, `a within 1 s after b` is `a and after(b, 1 s)`. */
    private fun readNearness(left: Node, wordFrom: Int, nesting: Int): Node {
        val time = readTime(wordFrom)
        scanner.skipSpace()
        val from = scanner.at
        val function = if (scanner.takeWord("after")) {
            Function.AFTER
        } else if (scanner.takeWord("before")) {
            Function.BEFORE
        } else {
            fail(wordFrom, scanner.at, "“within” needs a time, then “after” or “before”, as in within 1 s after x > 5.")
        }
        val other = expression(Precedence.NOT, nesting + 1)
        val call = made(Node.Call(from, scanner.at, function, listOf(other, time)))
        countTimeMove(call)
        return Node.Binary(Operator.AND, left, call)
    }

    private fun operand(nesting: Int): Node {
        if (scanner.isAtEnd()) {
            fail(text.length, text.length, "Something is missing here: a topic, a number or a function.")
        }
        val from = scanner.at
        return when (val first = text[from]) {
            '(' -> parenthesized(nesting)
            '\'' -> made(scanner.quoted('\'', "text").let { Node.Text(from, scanner.at, it) })
            '"', '`' -> scanner.quoted(first, "name").let { made(names.topic(it, from, scanner.at)) }
            '-', '−' -> negative(from, nesting)
            '!' -> negation(from, 1, nesting)
            else -> if (scanner.isNumberHere()) number() else word(from, nesting)
        }
    }

    private fun parenthesized(nesting: Int): Node {
        val from = scanner.at++
        val node = expression(Precedence.WHEN, nesting + 1)
        close(from)
        node.from = from
        node.until = scanner.at
        return node
    }

    private fun close(open: Int) {
        if (scanner.isAtEnd()) fail(open, open + 1, "This parenthesis is never closed.")
        if (text[scanner.at] != ')') failAtUnexpected()
        scanner.at++
    }

    private fun negative(from: Int, nesting: Int): Node {
        scanner.at++
        val operand = expression(Precedence.POWER, nesting + 1)
        if (operand is Node.Time && operand.seconds > 0) {
            return made(Node.Time(from, operand.until, -operand.seconds, "-${operand.written}"))
        }
        return made(Node.Negative(from, operand))
    }

    private fun negation(from: Int, length: Int, nesting: Int): Node {
        scanner.at += length
        return made(Node.Not(from, expression(Precedence.NOT, nesting + 1)))
    }

    private fun number(): Node {
        val number = scanner.number()
        if (number is Node.Time) requireTime(number.from, number.until)
        return made(number)
    }

    private fun axis(from: Int): Node {
        requireTime(from, scanner.at)
        return Node.Axis(from, scanner.at)
    }

    private fun requireTime(from: Int, until: Int) {
        if (vocabulary.hasTime) return
        val written = text.substring(from, until)
        val message = "The x axis of this log is not a time, so “$written” has no meaning; give it an x axis with a unit of time."
        fail(from, until, message, ExpressionErrorKind.NO_TIME)
    }

    private fun word(from: Int, nesting: Int): Node = when (val meaning = names.read()) {
        is Meaning.Topic -> made(meaning.node).also {
            plainNameFrom = it.from
            plainNameUntil = it.until
        }

        is Meaning.Call -> call(from, meaning.name, nesting)

        is Meaning.Keyword -> when (meaning.word) {
            "not" -> negation(from, meaning.word.length, nesting)

            else -> {
                scanner.at += meaning.word.length
                made(
                    when (meaning.word) {
                        "true", "false" -> Node.Truth(from, scanner.at, meaning.word == "true")
                        AXIS -> axis(from)
                        else -> Node.Enabled(from, scanner.at, Mode.entries.first { it.word == meaning.word })
                    },
                )
            }
        }
    }

    private fun call(from: Int, name: String, nesting: Int): Node {
        val arguments = ArrayList<Node>()
        scanner.at += name.length
        scanner.skipSpace()
        val open = scanner.at++
        if (!scanner.take(')')) {
            do arguments += expression(Precedence.WHEN, nesting + 1) while (scanner.take(','))
            close(open)
        }
        val functions = Function.called(name)
        val function = functions.find { it.parameters.size == arguments.size }
            ?: fail(from, scanner.at, "${functions[0].title} takes ${countsOf(functions)}, not ${arguments.size}.")
        val node = made(Node.Call(from, scanner.at, function, arguments))
        if (function.movesTimes) countTimeMove(node)
        return node
    }

    private fun countsOf(functions: List<Function>) = functions.joinToString(" or ") { function ->
        val count = function.parameters.size
        if (count == 1) "1 operand" else "$count operands"
    }

    private fun <T : Node> made(node: T): T {
        if (node.depth > Limits.DEPTH) failTooDeep(node.from, node.until)
        if (++nodes > Limits.NODES) {
            fail(node.from, node.until, "An expression has at most ${Limits.NODES} parts.", ExpressionErrorKind.LIMIT)
        }
        return node
    }

    private fun countTimeMove(node: Node) {
        if (++moves > Limits.MOVES) {
            val message = "An expression can use during, shift, after, before, first and last with a time at most ${Limits.MOVES} times."
            fail(node.from, node.until, message, ExpressionErrorKind.LIMIT)
        }
    }

    private fun failTooDeep(from: Int, until: Int): Nothing =
        fail(minOf(from, text.length), until, "This is nested too deeply.", ExpressionErrorKind.LIMIT)

    private fun failAtUnexpected(): Nothing {
        val from = scanner.at
        val found = scanner.restWord()
        fail(
            from,
            from + found.length,
            when (found) {
                ")" -> "This parenthesis was never opened."
                "&", "|" -> "“$found” is not an operator; write “$found$found”."
                "," -> "A comma only separates the operands of a function; write decimals with a point."
                else -> "“$found” is not expected here; an operator such as + or < may follow, or the end."
            },
        )
    }

    private fun fail(from: Int, until: Int, message: String, kind: ExpressionErrorKind = ExpressionErrorKind.SYNTAX): Nothing =
        throw Mistake(from, until, kind, message)

    private companion object {
        val TEXTS = setOf(SignalKind.STATE, SignalKind.EVENT)
        const val CHAINED = "Comparisons cannot be chained; write “a < b and b < c”."
    }
}

/**
 * The limits of an expression. They keep untrusted expressions from overflowing the stack, and bound the work: each node costs a pass over
 * the samples, and only functions that move times create more of them.
 */
internal object Limits {
    const val LENGTH = MAX_EXPRESSION_LENGTH
    const val NESTING = 100
    const val DEPTH = 200
    const val NODES = 500
    const val MOVES = 16
}
