package badlog.formats.wpilog

/**
 * Assigns offsets to the fields of a struct: one after another without padding. Consecutive bit-fields of the same width share their bytes,
 * lowest bits first; a boolean bit-field shares the bytes of any preceding one.
 *
 * The functions that add a field return false for an impossible field, or if the struct becomes too large.
 */
internal class StructPacking {
    private val leaves = ArrayList<Leaf>()
    private var offset = 0
    private var openWidth = 0
    private var usedBits = 0

    /** Returns the layout of the added fields. */
    fun layout() = ValueLayout(offset + openWidth, leaves)

    fun add(field: StructField, type: ValueType): Boolean {
        endBits()
        if (field.names != null && !type.isInteger) return false
        if (type == ValueType.CHAR) return addText(field)
        return addEach(field, type.width) { path, at -> leaves += Leaf(path, at, type, names = field.names) }
    }

    fun add(field: StructField, nested: ValueLayout): Boolean {
        endBits()
        if (nested.leaves.size.toLong() * (field.count ?: 1) + leaves.size > MAX_LEAVES) return false
        return addEach(field, nested.width) { path, at -> nested.leaves.mapTo(leaves) { it.inside(path, at) } }
    }

    fun addBits(field: StructField, type: ValueType): Boolean {
        val isBool = type == ValueType.BOOL
        if (!(type.isInteger || (isBool && field.bits == 1)) || field.bits > type.width * BITS) return false
        if (field.count != null || leaves.size == MAX_LEAVES) return false
        val joinsAny = isBool && openWidth > 0 && usedBits < openWidth * BITS
        if (!joinsAny && (openWidth != type.width || usedBits + field.bits > openWidth * BITS)) {
            endBits()
            openWidth = type.width
        }
        leaves += Leaf("/" + field.name, offset, type, bits = field.bits, shift = usedBits, names = field.names)
        usedBits += field.bits
        return offset <= MAX_WIDTH
    }

    private fun addText(field: StructField): Boolean {
        val count = field.count ?: 1
        if (count > MAX_WIDTH - offset || leaves.size == MAX_LEAVES) return false
        leaves += Leaf("/" + field.name, offset, ValueType.CHAR, count)
        offset += count
        return true
    }

    private inline fun addEach(field: StructField, width: Int, addAt: (path: String, offset: Int) -> Unit): Boolean {
        val count = field.count ?: 1
        if (width.toLong() * count > MAX_WIDTH - offset || (count > MAX_LEAVES - leaves.size && width > 0)) return false
        if (width == 0) return true
        for (i in 0 until count) {
            addAt("/" + field.name + if (field.count == null) "" else "[$i]", offset)
            offset += width
        }
        return true
    }

    private fun endBits() {
        offset += openWidth
        openWidth = 0
        usedBits = 0
    }
}

private const val BITS = 8

/** The maximum number of values: each is a topic and a graph. */
private const val MAX_LEAVES = 1024
private const val MAX_WIDTH = 1 shl 16
