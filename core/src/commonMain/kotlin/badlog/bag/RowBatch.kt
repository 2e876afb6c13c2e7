package badlog.bag

/**
 * Rows that a [RowBatchParser] read apart from those before them, for [BagParser.accept]. All of it is in arrays of numbers and
 * of texts, so that it can travel between threads and between the workers of a page.
 *
 * @property numbers for each column, in the order of the file, the numbers of its rows and perhaps room for more; empty arrays
 *   where samples are not kept.
 * @property details counts, lines, and which texts stand where. Only [BagParser] knows their order.
 * @property texts the texts that [details] speaks of.
 */
public class RowBatch(public val numbers: Array<DoubleArray>, public val details: IntArray, public val texts: Array<String>) {
    /** How many rows it holds. */
    public val rowCount: Int get() = details[0]

    /** Whether the numbers are there, not only their counts. */
    internal val hasSamples: Boolean get() = numbers.all { it.size >= rowCount }
    internal val lineCount: Int get() = details[1]
    internal val byteCount: Int get() = details[2]
    internal val sawCarriageReturn: Boolean get() = details[3] != 0
}

/** Gathers what a [RowBatch] says besides its numbers. */
internal class BatchWriter {
    private var integers = IntArray(256)
    private var size = 0
    private val texts = ArrayList<String>()

    fun put(value: Int) {
        if (size == integers.size) integers = integers.copyOf(size * 2)
        integers[size++] = value
    }

    fun put(values: IntArray, count: Int) {
        if (size + count > integers.size) integers = integers.copyOf(maxOf(size + count, size * 2))
        values.copyInto(integers, size, 0, count)
        size += count
    }

    fun put(text: String) {
        texts += text
    }

    fun batch(numbers: Array<DoubleArray>) = RowBatch(numbers, integers.copyOf(size), texts.toTypedArray())
}

/** Takes what a [BatchWriter] put, in its order. */
internal class BatchReader(private val batch: RowBatch, private var at: Int) {
    private var textAt = 0

    fun int(): Int = batch.details[at++]

    fun text(): String = batch.texts[textAt++]

    fun ints(into: IntArray, offset: Int, count: Int) {
        batch.details.copyInto(into, offset, at, at + count)
        at += count
    }

    companion object {
        /** The integers that are about all columns. */
        const val FRAME = 4
    }
}
