package badlog.formats.wpilog

import badlog.core.text.isLetterOrDigit

/** The structs that a file has described so far by schemas. */
internal class StructSchemas {
    private val fields = HashMap<String, List<StructField>>()
    private val layouts = HashMap<String, ValueLayout?>()

    /** The number of schemas so far. When it grows, a layout that was null may be available. */
    var version = 0
        private set

    /** Adds the schema of struct [name]. Of two with the same name, the first counts, since records may already have been read with it. */
    fun add(name: String, schema: String) {
        if (name in fields || fields.size == MAX_SCHEMAS) return
        fields[name] = SchemaReader.read(schema) ?: return
        layouts.clear()
        version++
    }

    /** Returns the layout of struct [name]; null if a schema is missing, invalid, or too large. */
    fun layoutOf(name: String): ValueLayout? = layoutOf(name, 0)

    private fun layoutOf(name: String, depth: Int): ValueLayout? {
        if (name in layouts) return layouts[name]
        val declared = fields[name] ?: return null
        // A struct that contains itself would never end.
        val layout = if (depth < MAX_DEPTH) laidOut(declared, depth) else null
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
}

/**
 * One declaration of a struct's schema.
 *
 * @property type the name of a [ValueType] or of another struct.
 * @property count for an array, the number of elements; otherwise null.
 * @property bits for a bit-field, the number of bits; otherwise 0.
 * @property names for an enumeration, the names of its numbers; otherwise null.
 */
internal class StructField(val name: String, val type: String, val count: Int?, val bits: Int, val names: Map<Long, ByteArray>?)

/**
 * Reads the schema of a struct: declarations with semicolons between them. Examples: `double x`, `int16 counts[4]`, `uint8 mode:3` and
 * `enum {off=0, on=1} int8 state`.
 */
internal class SchemaReader private constructor(private val text: String) {
    private var at = 0

    private class Malformed : Exception()

    private fun fields(): List<StructField> {
        val fields = ArrayList<StructField>()
        while (true) {
            while (peek() == ';') at++
            if (peek() == END) return fields
            fields += field()
            if (peek() != END) expect(';')
        }
    }

    private fun field(): StructField {
        var type = if (peek() == '{') "enum" else word()
        var names: Map<Long, ByteArray>? = null
        if (peek() == '{') {
            if (type != "enum") throw Malformed()
            names = enumeration()
            type = word()
        }
        val name = word()
        var count: Int? = null
        var bits = 0
        when (peek()) {
            '[' -> {
                at++
                count = number().toInt().takeIf { it >= 0 } ?: throw Malformed()
                expect(']')
            }

            ':' -> {
                at++
                bits = number().toInt().takeIf { it in 1..Long.SIZE_BITS } ?: throw Malformed()
            }
        }
        return StructField(name, type, count, bits, names)
    }

    private fun enumeration(): Map<Long, ByteArray> {
        val names = HashMap<Long, ByteArray>()
        expect('{')
        while (peek() != '}') {
            val name = word()
            expect('=')
            names[number()] = name.encodeToByteArray()
            if (peek() == ',') {
                at++
            } else if (peek() != '}') {
                throw Malformed()
            }
        }
        at++
        return names
    }

    private fun word(): String {
        peek()
        val start = at
        while (at < text.length && (isLetterOrDigit(text[at]) || text[at] == '_')) at++
        if (at == start || text[start] in '0'..'9') throw Malformed()
        return text.substring(start, at)
    }

    private fun number(): Long {
        val isNegative = peek() == '-'
        if (isNegative) at++
        val start = at
        while (at < text.length && text[at] in '0'..'9') at++
        val number = text.substring(start, at).toLongOrNull() ?: throw Malformed()
        return if (isNegative) -number else number
    }

    private fun expect(char: Char) {
        if (peek() != char) throw Malformed()
        at++
    }

    /** Returns the next character that is not a space, without consuming it; [END] if there is none. */
    private fun peek(): Char {
        while (at < text.length && text[at].isWhitespace()) at++
        return if (at < text.length) text[at] else END
    }

    companion object {
        private const val END = '\u0000'

        /** Returns the declarations of [schema], in order, or null if it is not a schema. */
        fun read(schema: String): List<StructField>? = try {
            SchemaReader(schema).fields()
        } catch (_: Malformed) {
            null
        }
    }
}

private const val MAX_DEPTH = 32
private const val MAX_SCHEMAS = 10_000
