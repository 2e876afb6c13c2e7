package badlog.expression.syntax

import badlog.expression.signals.Signal

/**
 * A part of an expression.
 *
 * @property from where it begins in the text, with its parentheses.
 * @property until where it ends.
 * @property children its operands.
 */
internal sealed class Node(var from: Int, var until: Int, val children: List<Node>) {
    /** How many nodes there are from here down to the deepest. */
    val depth: Int = 1 + (children.maxOfOrNull { it.depth } ?: 0)

    /** A number of its own within the expression. */
    var id: Int = -1

    /** What it gives, once checked. */
    lateinit var type: Type

    /** How its numbers become those of another unit, in which they are needed. */
    var conversion: Conversion? = null

    class Number(from: Int, until: Int, val value: Double, val digits: String) : Node(from, until, emptyList())

    class Time(from: Int, until: Int, val seconds: Double, val written: String) : Node(from, until, emptyList())

    /** A number with its unit, as it is written. */
    class Measured(from: Int, until: Int, val value: Double, val digits: String, val unit: String) : Node(from, until, emptyList())

    class Truth(from: Int, until: Int, val value: Boolean) : Node(from, until, emptyList())

    class Text(from: Int, until: Int, val text: String) : Node(from, until, emptyList())

    class Topic(from: Int, until: Int, val signal: Signal) : Node(from, until, emptyList())

    class Enabled(from: Int, until: Int, val mode: Mode) : Node(from, until, emptyList())

    /** The x axis. */
    class Axis(from: Int, until: Int) : Node(from, until, emptyList())

    class Negative(from: Int, val operand: Node) : Node(from, operand.until, listOf(operand))

    class Not(from: Int, val operand: Node) : Node(from, operand.until, listOf(operand))

    class Binary(val operator: Operator, val left: Node, val right: Node) : Node(left.from, right.until, listOf(left, right))

    class For(val condition: Node, val time: Time) : Node(condition.from, time.until, listOf(condition, time))

    class Call(from: Int, until: Int, val function: Function, val arguments: List<Node>) : Node(from, until, arguments)
}

/** In which mode a robot may be enabled; [ENABLED] is any. */
internal enum class Mode {
    ENABLED,
    AUTONOMOUS,
    TELEOP,
    ;

    /** How it is written. */
    val word: String get() = name.lowercase()
}

/** How the x axis is written. */
internal const val AXIS: String = "time"

/** What a part of an expression gives, and how an error calls it. */
internal enum class Kind(val title: String) {
    NUMBER("a number"),

    /** A time that is written with its unit; a number everywhere else. */
    TIME("a time"),

    /** Counts as 0 and 1 where a number is needed. */
    CONDITION("a condition"),
    TEXT("a text"),
    ;

    val isNumeric: Boolean get() = this != TEXT
}

/**
 * What a node gives: its [kind], one for each moment or one for the whole recording.
 *
 * @property isMomentary whether each is over at once, as events are.
 */
internal data class Type(val kind: Kind, val isOverTime: Boolean, val isMomentary: Boolean = false)
