package badlog.core.bag

/**
 * Rows that a [RowBatchParser] read independently of those before them, for [BagParser.accept]. It consists only of arrays of
 * numbers and texts, so that it can be passed between threads and between the workers of a page.
 *
 * @property numbers for each column, in the order of the file, the numbers of its rows, with possible spare room; empty arrays
 *   if samples are not kept.
 * @property details counts, lines, and the places of texts. Only [BagParser] knows their order.
 * @property texts the texts that [details] refers to.
 */
public class RowBatch(public val numbers: Array<DoubleArray>, public val details: IntArray, public val texts: Array<String>) {
    /** The number of rows. */
    public val rowCount: Int get() = details[0]

    /** Whether it has the numbers, not only their counts. */
    internal val hasSamples: Boolean get() = numbers.all { it.size >= rowCount }
    internal val lineCount: Int get() = details[1]
    internal val byteCount: Int get() = details[2]
    internal val sawCarriageReturn: Boolean get() = details[3] != 0
}

/** Collects the details and texts of a [RowBatch]. */
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

/** Reads the output of a [BatchWriter], in the same order. */
internal class BatchReader(private val batch: RowBatch, private var at: Int) {
    private var textAt = 0

    fun int(): Int = batch.details[at++]

    fun text(): String = batch.texts[textAt++]

    fun ints(into: IntArray, offset: Int, count: Int) {
        batch.details.copyInto(into, offset, at, at + count)
        at += count
    }

    companion object {
        /** The number of integers that concern all columns. */
        const val COMMON_INTS = 4
    }
}
