package badlog.wpilog

/**
 * What a record of one fixed size holds.
 *
 * @property width in bytes.
 * @property leaves its values, nested ones in the places of what they are nested in.
 */
internal class ValueLayout(val width: Int, val leaves: List<Leaf>) {
    companion object {
        private val SIMPLE = mapOf(
            "boolean" to ValueType.BOOL,
            "int64" to ValueType.INT64,
            "float" to ValueType.FLOAT,
            "double" to ValueType.DOUBLE,
        ).mapValues { (_, type) -> ValueLayout(type.width, listOf(Leaf("", 0, type))) }

        /** The layout of an entry's [type], where it is a simple one. */
        fun of(type: String): ValueLayout? = SIMPLE[type]
    }
}
