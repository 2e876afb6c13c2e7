package badlog.expression.syntax

import badlog.expression.samples.Operation
import badlog.expression.samples.known
import kotlin.math.pow

/**
 * An operator between two operands.
 *
 * A condition is 1, 0 or, if unknown, NaN. A comparison with a gap is unknown, and so is everything that depends on it.
 */
internal enum class Operator(
    val symbol: String,
    val precedence: Int,
    val group: Group,
    val operation: Operation,
    vararg val synonyms: String,
) {
    WHEN("when", Precedence.WHEN, Group.WHEN, Operation.WHEN),
    OR("or", Precedence.OR, Group.LOGIC, { a, b -> either(a, b) }, "||"),
    AND("and", Precedence.AND, Group.LOGIC, { a, b -> both(a, b) }, "&&"),
    CONTAINS("contains", Precedence.COMPARISON, Group.TEXT, { _, _ -> Double.NaN }),
    MATCHES("matches", Precedence.COMPARISON, Group.TEXT, { _, _ -> Double.NaN }),
    LESS_OR_EQUAL("<=", Precedence.COMPARISON, Group.ORDER, { a, b -> known(a, b, a <= b) }, "=<", "≤"),
    GREATER_OR_EQUAL(">=", Precedence.COMPARISON, Group.ORDER, { a, b -> known(a, b, a >= b) }, "=>", "≥"),
    EQUAL("==", Precedence.COMPARISON, Group.EQUALITY, Operation.EQUAL, "="),
    NOT_EQUAL("!=", Precedence.COMPARISON, Group.EQUALITY, { a, b -> known(a, b, a != b) }, "<>", "≠"),
    LESS("<", Precedence.COMPARISON, Group.ORDER, { a, b -> known(a, b, a < b) }),
    GREATER(">", Precedence.COMPARISON, Group.ORDER, { a, b -> known(a, b, a > b) }),
    PLUS("+", Precedence.SUM, Group.ARITHMETIC, { a, b -> a + b }),
    MINUS("-", Precedence.SUM, Group.ARITHMETIC, Operation.MINUS, "−"),
    TIMES("*", Precedence.PRODUCT, Group.ARITHMETIC, Operation.TIMES),
    DIVIDED_BY("/", Precedence.PRODUCT, Group.ARITHMETIC, { a, b -> a / b }),
    REMAINDER("%", Precedence.PRODUCT, Group.ARITHMETIC, { a, b -> a % b }),

    // Unlike elsewhere, a gap to the power of 0 stays a gap.
    POWER("^", Precedence.POWER, Group.ARITHMETIC, { a, b -> if (a.isNaN() || b.isNaN()) Double.NaN else a.pow(b) }),
    ;

    /** The operands that an operator takes. */
    enum class Group { WHEN, LOGIC, TEXT, ORDER, EQUALITY, ARITHMETIC }

    val isComparison: Boolean get() = precedence == Precedence.COMPARISON

    companion object {
        /** All spellings, ordered so that longer ones come before those they begin with. */
        val spellings: List<Pair<String, Operator>> =
            entries.flatMap { operator -> (listOf(operator.symbol) + operator.synonyms).map { it to operator } }
                .sortedByDescending { it.first.length }
    }
}

/** The precedence of operators; larger numbers bind more tightly. */
internal object Precedence {
    const val WHEN = 1
    const val OR = 2
    const val AND = 3
    const val FOR = 4
    const val NOT = 5
    const val COMPARISON = 6
    const val SUM = 7
    const val PRODUCT = 8
    const val NEGATIVE = 9
    const val POWER = 10
    const val OPERAND = 11
}

private fun either(a: Double, b: Double): Double = if (a == 1.0 || b == 1.0) {
    1.0
} else if (a == 0.0 && b == 0.0) {
    0.0
} else {
    Double.NaN
}

private fun both(a: Double, b: Double): Double = if (a == 0.0 || b == 0.0) {
    0.0
} else if (a == 1.0 && b == 1.0) {
    1.0
} else {
    Double.NaN
}
