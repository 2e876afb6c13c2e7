package badlog.formats.column

/**
 * The blocks of an array's elements. Elements that are in every record share their timestamps; an element that appears later or disappears
 * has its own, so that an array that was once long costs nothing afterwards.
 *
 * @param newBlock creates the block of the element with this index, or returns null if there are too many.
 */
internal class ElementBlocks(
    private val keepsSamples: Boolean,
    private val newBlock: (index: Int, timestamps: Timestamps) -> SampleBlock?,
) {
    companion object {
        /** The maximum number of elements shown: each is a topic and a graph. */
        const val MAX_ELEMENTS = 256
    }

    private val list = ArrayList<SampleBlock>()
    private var present = 0

    /** The times of all records. */
    val timestamps = Timestamps(keepsSamples)

    /** The existing blocks, in the order of the elements. */
    val blocks: List<SampleBlock> get() = list

    /** Returns the block for element [index] of the record at [time], to which the element must then be added. Null beyond the maximum. */
    fun next(index: Int, time: Double): SampleBlock? {
        if (index == list.size) {
            list += newBlock(index, if (timestamps.size == 0) timestamps else Timestamps(keepsSamples)) ?: return null
        }
        return list.getOrNull(index)?.also { it.meet(time, timestamps) }
    }

    /** Records that the record at [time] had [count] elements. */
    fun end(count: Int, time: Double) {
        for (i in count until present) list[i].miss(time, timestamps)
        present = minOf(count, list.size)
        timestamps.add(time)
    }
}
