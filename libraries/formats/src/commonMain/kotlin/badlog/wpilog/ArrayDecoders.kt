package badlog.wpilog

/** Payloads with any number of values, each of which gets a block of its own; those far behind are dropped. */
internal abstract class ArrayDecoder(private val source: ColumnSource, private val leafPaths: List<String>) : PayloadDecoder() {
    protected val elements = ElementBlocks(source.keepsSamples, ::newBlock)
    override val clock: Clock get() = elements.clock
    override val blocks: List<SampleBlock> get() = elements.blocks

    private fun newBlock(index: Int, clock: Clock): SampleBlock? {
        if (index >= MOST_ELEMENTS || !source.hasRoomFor(leafPaths.size)) return null
        return SampleBlock(source.columns(leafPaths.map { "[$index]$it" }), clock)
    }

    private companion object {
        /** Each is a topic, and a graph: more tell nobody anything. */
        const val MOST_ELEMENTS = 256
    }
}

/** Arrays of values of a fixed [layout]. */
internal class LayoutArrayDecoder(source: ColumnSource, private val layout: ValueLayout) :
    ArrayDecoder(source, layout.leaves.map { it.path }) {
    private val leaves = layout.leaves.toTypedArray()

    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        val size = until - from
        if (layout.width == 0 || size % layout.width != 0) {
            badCount++
            return
        }
        val count = size / layout.width
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
}

/** Arrays of texts: their number, then each with its length before it. */
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

    /** How many texts there are; -1 unless they fill the payload. */
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
