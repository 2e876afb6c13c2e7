package badlog.networktables

/**
 * The kind of value of a topic of NetworkTables.
 *
 * @property typeName its name in an announcement.
 * @property code its code in a value's message.
 */
enum class TopicType(val typeName: String, val code: Int) {
    BOOLEAN("boolean", 0),
    DOUBLE("double", 1),
    INT("int", 2),
    FLOAT("float", 3),
    STRING("string", 4),

    /** Bytes, described only by the topic's type name. */
    RAW("raw", 5),
    BOOLEANS("boolean[]", 16),
    DOUBLES("double[]", 17),
    INTS("int[]", 18),
    FLOATS("float[]", 19),
    STRINGS("string[]", 20),
    ;

    companion object {
        /** Returns the type for values of the type [name], as NetworkTables or a WPILOG calls it. */
        fun of(name: String): TopicType = when (name) {
            "int64" -> INT
            "int64[]" -> INTS
            "json" -> STRING
            else -> entries.find { it.typeName == name } ?: RAW
        }
    }
}
