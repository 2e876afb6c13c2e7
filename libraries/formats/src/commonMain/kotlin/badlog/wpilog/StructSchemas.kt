package badlog.wpilog

/** The structs whose schemas a file has brought so far. */
internal class StructSchemas {
    private val fields = HashMap<String, List<StructField>>()
    private val layouts = HashMap<String, ValueLayout?>()

    /** Grows with every schema, so that it is known when a layout may be asked for anew. */
    var version = 0
        private set

    /** Takes the schema of struct [name]. Of two with one name the first counts, as for records that were read by then. */
    fun add(name: String, schema: String) {
        if (name in fields || fields.size == MOST_SCHEMAS) return
        fields[name] = SchemaReader.read(schema) ?: return
        layouts.clear()
        version++
    }

    /** How struct [name] stands in bytes; null where a schema is missing, makes no sense, or is too large. */
    fun layoutOf(name: String): ValueLayout? = layoutOf(name, 0)

    private fun layoutOf(name: String, depth: Int): ValueLayout? {
        if (name in layouts) return layouts[name]
        val declared = fields[name] ?: return null
        // A struct that has itself as a field never ends.
        val layout = if (depth < DEEPEST) laidOut(declared, depth) else null
        if (depth == 0 || layout != null) layouts[name] = layout
        return layout
    }

    private fun laidOut(declared: List<StructField>, depth: Int): ValueLayout? {
        val packing = StructPacking()
        for (field in declared) {
            val type = ValueType.ofSchema(field.type)
            val isFitting = when {
                type == null -> {
                    val nested = if (field.bits > 0 || field.names != null) null else layoutOf(field.type, depth + 1)
                    nested != null && packing.add(field, nested)
                }

                field.bits > 0 -> packing.addBits(field, type)

                else -> packing.add(field, type)
            }
            if (!isFitting) return null
        }
        return packing.layout()
    }

    private companion object {
        const val DEEPEST = 32
        const val MOST_SCHEMAS = 10_000
    }
}
