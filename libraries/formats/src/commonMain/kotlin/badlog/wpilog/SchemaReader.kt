package badlog.wpilog

/**
 * Reads the schema of a struct: declarations such as `double x`, `int16 counts[4]`, `uint8 mode:3` and
 * `enum {off=0, on=1} int8 state`, with semicolons between them.
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
        while (at < text.length && (text[at].isLetterOrDigit() || text[at] == '_')) at++
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

    /** The next character that is no blank, which is not passed; [END] without one. */
    private fun peek(): Char {
        while (at < text.length && text[at].isWhitespace()) at++
        return if (at < text.length) text[at] else END
    }

    companion object {
        private const val END = '\u0000'

        /** The declarations of [schema] in their order, or null when it is none. */
        fun read(schema: String): List<StructField>? = try {
            SchemaReader(schema).fields()
        } catch (_: Malformed) {
            null
        }
    }
}
