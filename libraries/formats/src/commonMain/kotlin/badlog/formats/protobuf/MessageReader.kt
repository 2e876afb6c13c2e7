package badlog.formats.protobuf

/**
 * Reads messages of one [layout], one after another. If a field occurs twice, the last value counts, and messages that occur in
 * pieces are merged, as the encoding requires; unknown fields are skipped.
 */
internal class MessageReader(private val layout: MessageLayout) {
    private val bits = LongArray(layout.values.size)
    private val froms = IntArray(layout.values.size)
    private val ends = IntArray(layout.values.size)
    private val isThere = BooleanArray(layout.values.size)
    private val hasPart = BooleanArray(layout.partCount)

    /** The elements of each of the layout's lists. */
    val lists: List<MessageElements> = layout.lists.map { MessageElements() }

    /** Reads the message in [bytes] from [from] until [until]. Check it with [MessageLayout.fits] first. */
    fun read(bytes: ByteArray, from: Int, until: Int) {
        bits.fill(0)
        froms.fill(0)
        ends.fill(0)
        isThere.fill(false)
        hasPart.fill(false)
        for (elements in lists) elements.clear()
        read(layout.outermost, bytes, from, until)
    }

    /** Treats the element at [index] of the list [elements], which is not a message, as the whole message. */
    fun take(elements: MessageElements, index: Int) {
        hasPart[0] = true
        isThere[0] = true
        bits[0] = elements.bits[index]
        froms[0] = elements.froms[index]
        ends[0] = elements.ends[index]
    }

    /** Returns whether [value] is in the message, or has its default. */
    fun has(value: MessageValue): Boolean = isThere[value.index] || (hasPart[value.part] && !value.hasPresence)

    /** Returns the bits of [value], which must not be [WireReader.SIZED]. */
    fun bitsOf(value: MessageValue): Long = bits[value.index]

    /** Returns where the bytes of [value] begin, which must be [WireReader.SIZED]. */
    fun fromOf(value: MessageValue): Int = froms[value.index]

    /** Returns where the bytes of [value] end. */
    fun endOf(value: MessageValue): Int = ends[value.index]

    private fun read(part: MessagePart, bytes: ByteArray, from: Int, until: Int) {
        hasPart[part.index] = true
        val reader = WireReader(bytes, from, until)
        while (reader.next()) {
            when (val member = part.members[reader.number]) {
                null -> continue

                is MessageValue -> take(member, reader)

                is MessagePart -> read(member, bytes, reader.from, reader.end)

                is MessageList -> if (member.isPacked(reader)) {
                    val packed = WireReader(bytes, reader.from, reader.end)
                    while (packed.nextPacked(member.wire)) lists[member.index].add(packed)
                } else {
                    lists[member.index].add(reader)
                }
            }
        }
    }

    private fun take(value: MessageValue, reader: WireReader) {
        isThere[value.index] = true
        bits[value.index] = reader.bits
        froms[value.index] = reader.from
        ends[value.index] = reader.end
    }
}

/** The elements of a list in one message. */
internal class MessageElements {
    /** The bits of numbers. */
    var bits = LongArray(4)
        private set

    /** Where each text, byte array or message begins. */
    var froms = IntArray(4)
        private set

    /** Where each ends. */
    var ends = IntArray(4)
        private set

    /** The number of elements. */
    var size = 0
        private set

    fun clear() {
        size = 0
    }

    fun add(reader: WireReader) {
        if (size == bits.size) {
            bits = bits.copyOf(size * 2)
            froms = froms.copyOf(size * 2)
            ends = ends.copyOf(size * 2)
        }
        bits[size] = reader.bits
        froms[size] = reader.from
        ends[size++] = reader.end
    }
}
