package badlog.formats.wpilog

import badlog.formats.column.ColumnSource
import badlog.formats.column.ElementBlocks
import badlog.formats.column.SampleBlock
import badlog.formats.column.Timestamps

/** Turns the payloads of one entry into samples. */
internal abstract class PayloadDecoder {
    /** The number of payloads without the size that the type requires. */
    var badCount = 0

    /** The number of values that were dropped because too many topics exist. */
    var droppedValues = 0

    /** The number of poses in the longest path, if it has more than can be shown; otherwise 0. */
    var longestPath = 0

    /** The number of payloads that were dropped for lack of room before the description of their type arrived. */
    open val skippedCount: Int get() = 0

    /** Whether only the sizes of the payloads are shown. */
    open val isUndecoded: Boolean get() = false

    /** The times of all good records. */
    abstract val timestamps: Timestamps

    /** The decoded samples; may be empty. */
    abstract val blocks: List<SampleBlock>

    /** Returns whether the payload from [from] until [until] has the size that the type requires. */
    open fun fits(bytes: ByteArray, from: Int, until: Int): Boolean = true

    /** Accepts the payload from [from] until [until] of a record at [time]. */
    abstract fun accept(time: Double, bytes: ByteArray, from: Int, until: Int)

    /** Marks the end of the payloads. */
    open fun finish() = Unit
}

/** A decoder for payloads with one value, which goes to the [columns]. */
internal abstract class SingleDecoder(source: ColumnSource, paths: List<String>) : PayloadDecoder() {
    protected val columns = source.columns(paths)
    override val timestamps = Timestamps(source.keepsSamples)
    override val blocks = listOf(SampleBlock(columns, timestamps))
}

/** A decoder for payloads of a fixed [layout]: a number, or a struct. */
internal class LayoutDecoder(source: ColumnSource, private val layout: ValueLayout) :
    SingleDecoder(source, layout.leaves.map { it.path }) {
    private val leaves = layout.leaves.toTypedArray()

    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        if (!fits(bytes, from, until)) {
            badCount++
            return
        }
        for (i in leaves.indices) leaves[i].read(bytes, from, columns[i])
        timestamps.add(time)
    }

    override fun fits(bytes: ByteArray, from: Int, until: Int): Boolean = until - from == layout.width
}

/** A decoder for payloads that are texts. */
internal class TextPayloadDecoder(source: ColumnSource) : SingleDecoder(source, listOf("")) {
    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        columns[0].addText(bytes, from, until)
        timestamps.add(time)
    }
}

/** A decoder for payloads of unknown types: it keeps only their sizes, in bytes. */
internal class SizeDecoder(source: ColumnSource) : SingleDecoder(source, listOf("")) {
    override val isUndecoded: Boolean get() = true

    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        columns[0].addNumber((until - from).toDouble())
        timestamps.add(time)
    }
}

/** A decoder for payloads without a column, because none is left; it only counts them. */
internal class NoDecoder : PayloadDecoder() {
    override val timestamps = Timestamps(false)
    override val blocks get() = emptyList<SampleBlock>()

    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        droppedValues++
    }
}

/** A decoder for payloads that the caller does not want. */
internal class UnwantedDecoder : PayloadDecoder() {
    override val timestamps = Timestamps(false)
    override val blocks get() = emptyList<SampleBlock>()

    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) = Unit
}

/** A decoder for payloads that are arrays of any length. Each element index has its own block; elements beyond the maximum are dropped. */
internal abstract class ArrayDecoder(private val source: ColumnSource, private val leafPaths: List<String>) : PayloadDecoder() {
    protected val elements = ElementBlocks(source.keepsSamples, ::newBlock)
    override val timestamps: Timestamps get() = elements.timestamps
    override val blocks: List<SampleBlock> get() = elements.blocks

    private fun newBlock(index: Int, timestamps: Timestamps): SampleBlock? {
        if (index >= ElementBlocks.MAX_ELEMENTS || !source.hasRoomFor(leafPaths.size)) return null
        return SampleBlock(source.columns(leafPaths.map { "[$index]$it" }), timestamps)
    }
}

/** A decoder for arrays of values of a fixed [layout]. */
internal class LayoutArrayDecoder(source: ColumnSource, private val layout: ValueLayout) :
    ArrayDecoder(source, layout.leaves.map { it.path }) {
    private val leaves = layout.leaves.toTypedArray()

    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        if (!fits(bytes, from, until)) {
            badCount++
            return
        }
        val count = (until - from) / layout.width
        for (index in 0 until count) {
            val block = elements.next(index, time)
            if (block == null) {
                droppedValues += count - index
                break
            }
            val columns = block.columns
            for (i in leaves.indices) leaves[i].read(bytes, from + index * layout.width, columns[i])
        }
        elements.end(count, time)
    }

    override fun fits(bytes: ByteArray, from: Int, until: Int): Boolean = layout.width > 0 && (until - from) % layout.width == 0
}

/** A decoder for arrays of texts: their number, then each text after its length. */
internal class TextArrayDecoder(source: ColumnSource) : ArrayDecoder(source, listOf("")) {
    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        val count = countOf(bytes, from, until)
        if (count < 0) {
            badCount++
            return
        }
        var at = from + Int.SIZE_BYTES
        for (index in 0 until count) {
            val block = elements.next(index, time)
            if (block == null) {
                droppedValues += count - index
                break
            }
            val size = intAt(bytes, at)
            block.columns[0].addText(bytes, at + Int.SIZE_BYTES, at + Int.SIZE_BYTES + size)
            at += Int.SIZE_BYTES + size
        }
        elements.end(count, time)
    }

    override fun fits(bytes: ByteArray, from: Int, until: Int): Boolean = countOf(bytes, from, until) >= 0

    /** Returns the number of texts; -1 unless they fill the payload exactly. */
    private fun countOf(bytes: ByteArray, from: Int, until: Int): Int {
        if (until - from < Int.SIZE_BYTES) return -1
        val count = intAt(bytes, from)
        if (count !in 0..(until - from) / Int.SIZE_BYTES - 1) return -1
        var at = from + Int.SIZE_BYTES
        repeat(count) {
            if (until - at < Int.SIZE_BYTES) return -1
            val size = intAt(bytes, at)
            if (size !in 0..until - at - Int.SIZE_BYTES) return -1
            at += Int.SIZE_BYTES + size
        }
        return if (at == until) count else -1
    }
}
