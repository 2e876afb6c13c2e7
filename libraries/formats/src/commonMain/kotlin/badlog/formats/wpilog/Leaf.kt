package badlog.formats.wpilog

import badlog.formats.column.SampleColumn

/**
 * One value inside a record of a fixed layout.
 *
 * @property path the part of the topic's name after the entry's: empty, or `/` and the names of the fields.
 * @property offset where it begins, in bytes.
 * @property count for a text, the number of characters; otherwise 1.
 * @property bits for a bit-field, the number of bits; otherwise 0.
 * @property shift where its bits begin.
 * @property names for an enumeration, the names of its numbers; otherwise null.
 */
internal class Leaf(
    val path: String,
    val offset: Int,
    val type: ValueType,
    private val count: Int = 1,
    private val bits: Int = 0,
    private val shift: Int = 0,
    private val names: Map<Long, ByteArray>? = null,
) {
    /** Returns the same value inside a struct that begins at [offset], with [prefix] before its path. */
    fun inside(prefix: String, offset: Int) = Leaf(prefix + path, offset + this.offset, type, count, bits, shift, names)

    /** Adds the value in the record that begins at [start] to [column]. */
    fun read(bytes: ByteArray, start: Int, column: SampleColumn) {
        val at = start + offset
        if (names != null || bits > 0) return addBits(integer(bytes, at), column)
        when (type) {
            ValueType.DOUBLE -> column.addNumber(Double.fromBits(longAt(bytes, at)))
            ValueType.FLOAT -> column.addNumber(Float.fromBits(intAt(bytes, at)).toDouble())
            ValueType.BOOL -> column.addTruth(bytes[at].toInt() != 0)
            ValueType.INT8 -> column.addNumber(bytes[at].toDouble())
            ValueType.UINT8 -> column.addNumber((bytes[at].toInt() and 0xFF).toDouble())
            ValueType.INT16 -> column.addNumber(unsignedAt(bytes, at, 2).toShort().toDouble())
            ValueType.UINT16 -> column.addNumber(unsignedAt(bytes, at, 2).toDouble())
            ValueType.INT32 -> column.addNumber(intAt(bytes, at).toDouble())
            ValueType.UINT32 -> column.addNumber(intAt(bytes, at).toUInt().toDouble())
            ValueType.INT64 -> column.addLong(longAt(bytes, at))
            ValueType.UINT64 -> column.addUnsigned(longAt(bytes, at))
            ValueType.CHAR -> addCharacters(bytes, at, column)
        }
    }

    // A text shorter than its field is padded with NULs.
    private fun addCharacters(bytes: ByteArray, at: Int, column: SampleColumn) {
        var end = at
        while (end < at + count && bytes[end].toInt() != 0) end++
        column.addText(bytes, at, end)
    }

    private fun addBits(number: Long, column: SampleColumn) {
        when {
            names != null -> {
                val text = names[number] ?: number.toString().encodeToByteArray()
                column.addText(text, 0, text.size)
            }

            type == ValueType.BOOL -> column.addTruth(number != 0L)

            type == ValueType.UINT64 -> column.addUnsigned(number)

            else -> column.addLong(number)
        }
    }

    private fun integer(bytes: ByteArray, at: Int): Long {
        val size = type.width * BITS
        var number = 0L
        for (i in storageWidth - 1 downTo 0) number = (number shl BITS) or (bytes[at + i].toLong() and 0xFF)
        val width = if (bits > 0) bits else size
        if (bits > 0) number = number ushr shift
        val unused = Long.SIZE_BITS - width
        return if (type.isSigned) number shl unused shr unused else number shl unused ushr unused
    }

    // A boolean bit-field may be in the bytes of the integer before it.
    private val storageWidth get() = if (bits > 0) (shift + bits + BITS - 1) / BITS else type.width
}

private const val BITS = 8
