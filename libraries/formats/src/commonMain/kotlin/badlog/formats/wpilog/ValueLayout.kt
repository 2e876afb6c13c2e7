package badlog.formats.wpilog

/**
 * The encoding of a single value.
 *
 * @property width its size in bytes; for a text, 1 per character.
 * @property isSigned whether a bit-field of it has a sign.
 */
internal enum class ValueType(val width: Int, val isSigned: Boolean = false) {
    BOOL(1),
    CHAR(1),
    INT8(1, true),
    INT16(2, true),
    INT32(4, true),
    INT64(8, true),
    UINT8(1),
    UINT16(2),
    UINT32(4),
    UINT64(8),
    FLOAT(4),
    DOUBLE(8),
    ;

    /** Whether it may be a bit-field or an enumeration. */
    val isInteger: Boolean get() = this in INT8..UINT64

    companion object {
        /** Returns the type that a struct's schema calls [name], or null. */
        fun ofSchema(name: String): ValueType? = when (name) {
            "float32" -> FLOAT
            "float64" -> DOUBLE
            else -> entries.firstOrNull { it.name.lowercase() == name }
        }
    }
}

/**
 * The content of a record with a fixed size.
 *
 * @property width the size in bytes.
 * @property leaves its values, nested ones in the place of their struct.
 */
internal class ValueLayout(val width: Int, val leaves: List<Leaf>) {
    companion object {
        private val SIMPLE = mapOf(
            "boolean" to ValueType.BOOL,
            "int64" to ValueType.INT64,
            // As NetworkTables calls it.
            "int" to ValueType.INT64,
            "float" to ValueType.FLOAT,
            "double" to ValueType.DOUBLE,
        ).mapValues { (_, type) -> ValueLayout(type.width, listOf(Leaf("", 0, type))) }

        /** Returns the layout of an entry's [type], if it is a simple one. */
        fun of(type: String): ValueLayout? = SIMPLE[type]
    }
}
