package badlog.formats.column

import badlog.core.recording.CellCounts
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.text.TextDecoder
import badlog.core.text.TextPool

/**
 * The samples of one topic while its file is being read.
 *
 * @property path the part of the topic's name after the entry's.
 * @param keepsSamples false to count only, in memory that does not grow.
 */
internal class SampleColumn(val path: String, private val keepsSamples: Boolean, private val decoder: TextDecoder) {
    private val numbers = GrowingDoubles()
    private var texts: TextPool? = null
    private var textRows = IntArray(0)
    private var textIds = IntArray(0)
    private var size = 0
    private var notFiniteCount = 0
    private var truthCount = 0
    private var textCount = 0
    private var gapCount = 0

    /** The number of whole numbers that could not be kept exactly. */
    var roundedCount = 0
        private set

    /** Whether a text was not UTF-8. */
    var sawOtherText = false
        private set

    fun addNumber(number: Double) {
        if (!number.isFinite()) notFiniteCount++
        add(number)
    }

    fun addLong(number: Long) {
        if (number > MAX_EXACT || number < -MAX_EXACT) roundedCount++
        add(number.toDouble())
    }

    fun addUnsigned(bits: Long) {
        if (bits > MAX_EXACT || bits < 0) roundedCount++
        add(bits.toULong().toDouble())
    }

    fun addTruth(isTrue: Boolean) {
        truthCount++
        add(if (isTrue) 1.0 else 0.0)
    }

    fun addGap() {
        gapCount++
        add(Double.NaN)
    }

    fun addText(bytes: ByteArray, from: Int, until: Int) {
        if (keepsSamples) {
            val pool = texts ?: TextPool(decoder).also { texts = it }
            val known = pool.dictionary.size
            val id = pool.idOf(bytes, from, until)
            if (id == known && decoder.wasNotUtf8) sawOtherText = true
            if (textCount == textRows.size) {
                textRows = textRows.copyOf(maxOf(4, textCount * 2))
                textIds = textIds.copyOf(textRows.size)
            }
            textRows[textCount] = size
            textIds[textCount] = id
        } else if (!sawOtherText && !decoder.isUtf8(bytes, from, until)) {
            sawOtherText = true
        }
        textCount++
        size++
    }

    // A column of texts needs no memory for numbers.
    private fun add(number: Double) {
        if (keepsSamples && textCount == 0) numbers.add(number)
        size++
    }

    /**
     * Returns a topic [like] its entry, but with these samples at the times of [timestamps], which must be finished. The column must not be
     * used afterwards.
     */
    fun build(name: String, like: Topic, timestamps: Timestamps): Topic {
        val order = timestamps.order
        val isNumeric = size - textCount - gapCount > 0
        val samples = when {
            !keepsSamples || !isNumeric -> DoubleArray(0)
            order == null -> numbers.take()
            else -> numbers.take().let { all -> DoubleArray(order.size) { all[order[it]] } }
        }
        val column = when {
            textCount == 0 || !keepsSamples -> TextColumn.EMPTY
            order != null -> reordered(order)
            else -> TextColumn(textRows.copyOf(textCount), textIds.copyOf(textCount), texts?.dictionary.orEmpty())
        }
        val counts = counts(if (order == null) size else order.size, samples, column)
        return like.copy(name = name, samples = samples, texts = column, counts = counts, times = timestamps.times)
    }

    private fun reordered(order: IntArray): TextColumn {
        val textAt = IntArray(size) { -1 }
        for (i in 0 until textCount) textAt[textRows[i]] = i
        val rows = order.indices.filter { textAt[order[it]] >= 0 }.toIntArray()
        val ids = IntArray(rows.size) { textIds[textAt[order[rows[it]]]] }
        return TextColumn(rows, ids, texts?.dictionary.orEmpty())
    }

    /** Returns the counts of [total] samples, minus those that were dropped. */
    private fun counts(total: Int, samples: DoubleArray, column: TextColumn): CellCounts {
        val isAll = total == size
        val textsLeft = if (isAll) textCount else column.size
        val notFiniteLeft = if (isAll) notFiniteCount else minOf(notFiniteCount, samples.count { !it.isFinite() })
        val gapsLeft = when {
            isAll -> gapCount
            samples.isEmpty() -> total - textsLeft
            else -> samples.count { !it.isFinite() } - notFiniteLeft
        }
        val numeric = total - textsLeft - gapsLeft - notFiniteLeft
        return CellCounts(
            numbers = if (truthCount > 0) 0 else numeric,
            notFinite = notFiniteLeft,
            truthValues = if (truthCount > 0) numeric else 0,
            texts = textsLeft,
            empty = gapsLeft,
            gaps = if (textsLeft > 0) 1 else gapsLeft,
        )
    }
}

/** The columns that one record, or one element of an array, fills, all at the same times. */
internal class SampleBlock(val columns: List<SampleColumn>, timestamps: Timestamps) {
    /** The times of the columns. */
    var timestamps: Timestamps = timestamps
        private set
    private var isInGap = false

    /** Records a sample at [time]. The block may still use [shared], which its owner advances. */
    fun meet(time: Double, shared: Timestamps) {
        isInGap = false
        if (timestamps !== shared) timestamps.add(time)
    }

    /** Records that the array no longer has this element at [time]. After the gap, the block has its own timestamps. */
    fun miss(time: Double, shared: Timestamps) {
        if (isInGap) return
        isInGap = true
        if (timestamps === shared) timestamps = shared.copy()
        timestamps.add(time)
        for (column in columns) column.addGap()
    }
}

/** Creates the columns of a file, up to the maximum. */
internal class ColumnSource(val keepsSamples: Boolean) {
    private val decoder = TextDecoder()
    private var made = 0

    /** Returns whether [count] more columns are allowed. */
    fun hasRoomFor(count: Int): Boolean = made + count <= MAX_COLUMNS

    /** Returns a column for each of [paths]. */
    fun columns(paths: List<String>): List<SampleColumn> {
        made += paths.size
        return paths.map { SampleColumn(it, keepsSamples, decoder) }
    }
}

private const val MAX_EXACT = 1L shl 53

/** The maximum number of columns: no program shows more topics, and a damaged file could produce millions. */
private const val MAX_COLUMNS = 1 shl 16
