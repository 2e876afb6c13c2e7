package badlog.formats.wpilog

import badlog.formats.column.ColumnSource
import badlog.formats.column.ElementBlocks
import badlog.formats.column.SampleBlock
import badlog.formats.column.SampleColumn
import badlog.formats.column.Timestamps
import badlog.formats.protobuf.MessageLayout
import badlog.formats.protobuf.MessageList
import badlog.formats.protobuf.MessageReader
import badlog.formats.protobuf.MessageValue
import badlog.formats.protobuf.ScalarType

/** A decoder for payloads that are Protocol Buffers messages with this [layout]. */
internal class ProtoDecoder(source: ColumnSource, private val layout: MessageLayout) :
    SingleDecoder(source, layout.values.map { it.path }) {
    private val reader = MessageReader(layout)
    private val lists = layout.lists.map { ListTopics(source, it, it.path) }

    override val blocks: List<SampleBlock> get() = super.blocks + lists.flatMap { it.blocks }

    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        if (!fits(bytes, from, until)) {
            badCount++
            return
        }
        reader.read(bytes, from, until)
        for (value in layout.values) columns[value.index].add(value, reader, bytes)
        for (list in lists) droppedValues += list.add(time, bytes, reader)
        timestamps.add(time)
    }

    override fun fits(bytes: ByteArray, from: Int, until: Int): Boolean = layout.fits(bytes, from, until)
}

/** The topics of a [list], named after the entry and [path]. */
private class ListTopics(private val source: ColumnSource, private val list: MessageList, private val path: String) {
    private val reader = MessageReader(list.element)
    private val elements = ElementBlocks(source.keepsSamples, ::newBlock)

    // The lists in each element.
    private val inner = ArrayList<List<ListTopics>>()

    val blocks: List<SampleBlock> get() = elements.blocks + inner.flatten().flatMap { it.blocks }

    /** Adds this list from the message that [outer] has read. Returns the number of dropped values. */
    fun add(time: Double, bytes: ByteArray, outer: MessageReader): Int {
        val found = outer.lists[list.index]
        var dropped = 0
        for (index in 0 until found.size) {
            val block = elements.next(index, time)
            if (block == null) {
                dropped += found.size - index
                break
            }
            if (list.type == null) reader.read(bytes, found.froms[index], found.ends[index]) else reader.take(found, index)
            for (value in list.element.values) block.columns[value.index].add(value, reader, bytes)
            for (innerList in inner[index]) dropped += innerList.add(time, bytes, reader)
        }
        for (index in found.size until inner.size) inner[index].forEach { it.end(time) }
        elements.end(found.size, time)
        return dropped
    }

    /** Records that the list is missing at [time]. */
    private fun end(time: Double) {
        for (index in inner.indices) inner[index].forEach { it.end(time) }
        elements.end(0, time)
    }

    private fun newBlock(index: Int, timestamps: Timestamps): SampleBlock? {
        val element = list.element
        if (index >= ElementBlocks.MAX_ELEMENTS || !source.hasRoomFor(element.values.size)) return null
        inner += element.lists.map { ListTopics(source, it, "$path[$index]${it.path}") }
        return SampleBlock(source.columns(element.values.map { "$path[$index]${it.path}" }), timestamps)
    }
}

private fun SampleColumn.add(value: MessageValue, reader: MessageReader, bytes: ByteArray) {
    if (!reader.has(value)) return addGap()
    val bits = reader.bitsOf(value)
    when (value.type) {
        ScalarType.DOUBLE -> addNumber(Double.fromBits(bits))
        ScalarType.FLOAT -> addNumber(Float.fromBits(bits.toInt()).toDouble())
        ScalarType.INT64, ScalarType.SFIXED64 -> addLong(bits)
        ScalarType.UINT64, ScalarType.FIXED64 -> addUnsigned(bits)
        ScalarType.INT32, ScalarType.SFIXED32 -> addNumber(bits.toInt().toDouble())
        ScalarType.UINT32, ScalarType.FIXED32 -> addNumber(bits.toUInt().toDouble())
        ScalarType.SINT32 -> addNumber(fromZigzag(bits).toInt().toDouble())
        ScalarType.SINT64 -> addLong(fromZigzag(bits))
        ScalarType.BOOL -> addTruth(bits != 0L)
        ScalarType.STRING -> addText(bytes, reader.fromOf(value), reader.endOf(value))
        ScalarType.BYTES -> addNumber((reader.endOf(value) - reader.fromOf(value)).toDouble())
        ScalarType.ENUM -> (value.names?.get(bits) ?: bits.toInt().toString().encodeToByteArray()).let { addText(it, 0, it.size) }
    }
}

/** Small numbers of either sign are encoded as small ones: 0, -1, 1, -2. */
private fun fromZigzag(bits: Long) = (bits ushr 1) xor -(bits and 1)
