package badlog.replay

/**
 * What kind of value a topic of NetworkTables has.
 *
 * @property typeName what an announcement calls it.
 * @property code what a value's message calls it.
 */
internal enum class SignalType(val typeName: String, val code: Int) {
    BOOLEAN("boolean", 0),
    DOUBLE("double", 1),
    STRING("string", 4),
}
