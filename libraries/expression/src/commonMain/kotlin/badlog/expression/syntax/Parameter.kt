package badlog.expression.syntax

/** The operands that a function accepts, and their name in errors. */
internal enum class Parameter(val needed: String) {
    VARYING("something that changes over time"),
    VARYING_NUMBERS("numbers that change over time"),
    VARYING_CONDITION("a condition that changes over time, such as x > 0"),
    VARYING_TEXTS("a topic of texts"),
    TEXT("a text in single quotes"),
    NUMBERS("a number"),
    CONDITION("a condition, such as x > 0"),

    /** A number or a condition. */
    NUMBERS_OR_CONDITION("a number or a condition"),
    ONE_NUMBER("one number for the whole log"),
    WINDOW("a time above 0 with its unit, such as 1 s"),
    SHIFT("a time with its unit, such as 0.1 s"),
    SHARE("a number from 0 to 100"),
    ;

    /** Returns whether [node], which already has its type, is accepted. */
    fun accepts(node: Node): Boolean {
        val type = node.type
        return when (this) {
            VARYING -> type.isOverTime
            VARYING_NUMBERS -> type.isOverTime && type.kind.isNumeric
            VARYING_CONDITION -> type.isOverTime && type.kind == Kind.CONDITION
            VARYING_TEXTS -> type.isOverTime && type.kind == Kind.TEXT
            TEXT -> node is Node.Text
            NUMBERS, NUMBERS_OR_CONDITION -> type.kind.isNumeric
            CONDITION -> type.kind == Kind.CONDITION
            ONE_NUMBER -> !type.isOverTime && type.kind.isNumeric
            WINDOW -> node is Node.Time && node.seconds > 0
            SHIFT -> node is Node.Time
            SHARE -> node is Node.Number && node.value in 0.0..100.0
        }
    }
}
