package badlog.expression.syntax

import badlog.expression.signals.Signal

/**
 * A part of an expression.
 *
 * @property from the index in the text at which it begins, with its parentheses.
 * @property until the index at which it ends.
 * @property children its operands.
 */
internal sealed class Node(var from: Int, var until: Int, val children: List<Node>) {
    /** The number of nodes from here down to the deepest. */
    val depth: Int = 1 + (children.maxOfOrNull { it.depth } ?: 0)

    /** Its unique number within the expression. */
    var id: Int = -1

    /** The type of its result, once checked. */
    lateinit var type: Type

    /** The conversion of its numbers to another required unit; null for none. */
    var conversion: Conversion? = null

    class Number(from: Int, until: Int, val value: Double, val digits: String) : Node(from, until, emptyList())

    class Time(from: Int, until: Int, val seconds: Double, val written: String) : Node(from, until, emptyList())

    /** A number with its unit, as it is written. */
    class Measured(from: Int, until: Int, val value: Double, val digits: String, val unit: String) : Node(from, until, emptyList())

    class Truth(from: Int, until: Int, val value: Boolean) : Node(from, until, emptyList())

    class Text(from: Int, until: Int, val text: String) : Node(from, until, emptyList())

    class Topic(from: Int, until: Int, val signal: Signal) : Node(from, until, emptyList())

    class Enabled(from: Int, until: Int, val mode: Mode) : Node(from, until, emptyList())

    class Axis(from: Int, until: Int) : Node(from, until, emptyList())

    class Negative(from: Int, val operand: Node) : Node(from, operand.until, listOf(operand))

    class Not(from: Int, val operand: Node) : Node(from, operand.until, listOf(operand))

    class Binary(val operator: Operator, val left: Node, val right: Node) : Node(left.from, right.until, listOf(left, right))

    class For(val condition: Node, val time: Time) : Node(condition.from, time.until, listOf(condition, time))

    class Call(from: Int, until: Int, val function: Function, val arguments: List<Node>) : Node(from, until, arguments)
}

/** The modes in which a robot can be enabled; [ENABLED] is any of them. */
internal enum class Mode {
    ENABLED,
    AUTONOMOUS,
    TELEOP,
    ;

    val word: String get() = name.lowercase()
}

/** The word for the x axis in expressions. */
internal const val AXIS: String = "time"

/** The kind of a result, and its name in errors. */
internal enum class Kind(val title: String) {
    NUMBER("a number"),

    /** A time written with its unit; elsewhere it is a number. */
    TIME("a time"),

    /** A condition; it counts as 0 and 1 where a number is needed. */
    CONDITION("a condition"),
    TEXT("a text"),
    ;

    val isNumeric: Boolean get() = this != TEXT
}

/**
 * The type of a node's result: its [kind], and whether it varies over time.
 *
 * @property isOverTime whether there is a result for each moment; otherwise there is one for the whole recording.
 * @property isMomentary whether each result holds only for an instant, like an event.
 */
internal data class Type(val kind: Kind, val isOverTime: Boolean, val isMomentary: Boolean = false)
