package badlog.wpilog

/**
 * The blocks of an array's elements. Those that every record has share one clock; an element that comes later or goes
 * missing has its own, so that an array which was long once costs nothing afterwards.
 *
 * @param newBlock makes the block of the element with this index, or null when there are too many.
 */
internal class ElementBlocks(private val keepsSamples: Boolean, private val newBlock: (index: Int, clock: Clock) -> SampleBlock?) {
    private val list = ArrayList<SampleBlock>()
    private var present = 0

    /** The times of all records. */
    val clock = Clock(keepsSamples)

    /** Those there are, in the order of the elements. */
    val blocks: List<SampleBlock> get() = list

    /** The block for element [index] of the record at [time], to which it then has to be added; null beyond what is kept. */
    fun next(index: Int, time: Double): SampleBlock? {
        if (index == list.size) {
            list += newBlock(index, if (clock.size == 0) clock else Clock(keepsSamples)) ?: return null
        }
        return list.getOrNull(index)?.also { it.meet(time, clock) }
    }

    /** Says that the record at [time] has had [count] elements. */
    fun end(count: Int, time: Double) {
        for (i in count until present) list[i].miss(time, clock)
        present = minOf(count, list.size)
        clock.add(time)
    }
}
