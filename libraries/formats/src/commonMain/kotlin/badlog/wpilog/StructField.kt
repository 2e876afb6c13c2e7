package badlog.wpilog

/**
 * One declaration of a struct's schema.
 *
 * @property type what stands there: the name of a [ValueType] or of another struct.
 * @property count how many of it there are, of an array; null of a single one.
 * @property bits how many bits it has, of a bit-field; else 0.
 * @property names what its numbers are called, of an enumeration; else null.
 */
internal class StructField(val name: String, val type: String, val count: Int?, val bits: Int, val names: Map<Long, ByteArray>?)
