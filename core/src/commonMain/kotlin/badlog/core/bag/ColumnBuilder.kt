package badlog.core.bag

import badlog.core.recording.CellCounts
import badlog.core.recording.NumberSink
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.text.LF
import badlog.core.text.TextDecoder
import badlog.core.text.TextPool

/**
 * One column while its file is being read: a growing array of numbers, the sparse texts, and counts of oddities.
 *
 * @property name the name of its topic.
 * @property readsDecimalComma false for a topic of texts, in which `1,5` may be meant literally.
 * @param keepsSamples false to count only, in memory that does not grow.
 * @param sink receives the numbers instead of this column; null for none.
 */
internal class ColumnBuilder(
    val name: String,
    val readsDecimalComma: Boolean,
    private val keepsSamples: Boolean,
    private val decoder: TextDecoder,
    private val sink: NumberSink? = null,
) {
    private val keepsNumbers = keepsSamples && sink == null

    /** Whether its numbers go to a sink. */
    val hasSink: Boolean get() = sink != null
    private var numbers = DoubleArray(0)
    private var texts: TextPool? = null
    private var textRows = IntArray(0)
    private var textIds = IntArray(0)
    private var lastTextRow = -1
    private var lastTextSize = 0
    private var isLastTextNew = false

    private var notFiniteCount = 0
    private var truthCount = 0
    private var textCount = 0
    private var emptyCount = 0
    private var gapCount = 0
    private var lastGapRow = -2
    private var firstGapRow = -1

    /** The first text found, in the form for a message, and the line it is on. */
    var firstText: String? = null
        private set
    var firstTextLine = 0
        private set
    var decimalCommas = 0
        private set
    var firstDecimalCommaLine = 0
        private set
    var notUtf8Line = 0
        private set

    /** The number of whole numbers that lost their last digits. */
    var roundedCount = 0
        private set

    fun addNumber(row: Int, number: Double) {
        if (!keepsNumbers) {
            sink?.add(row, number)
            return
        }
        if (row >= numbers.size) grow(row)
        numbers[row] = number
    }

    fun addNotFinite(row: Int, number: Double) {
        notFiniteCount++
        addNumber(row, number)
    }

    fun addRounded(row: Int, number: Double) {
        roundedCount++
        addNumber(row, number)
    }

    fun addTruthValue(row: Int, number: Double) {
        truthCount++
        addNumber(row, number)
    }

    fun addEmpty(row: Int) {
        emptyCount++
        addGap(row)
    }

    fun addDecimalComma(row: Int, number: Double, line: Int) {
        if (decimalCommas++ == 0) firstDecimalCommaLine = line
        addNumber(row, number)
    }

    fun addText(row: Int, bytes: ByteArray, from: Int, until: Int, line: Int) {
        addGap(row)
        lastTextRow = row
        lastTextSize = until - from
        if (keepsSamples) {
            keepText(row, bytes, from, until, line)
        } else if (notUtf8Line == 0 && !decoder.isUtf8(bytes, from, until)) {
            notUtf8Line = line
        }
        if (textCount++ == 0) {
            firstText = decoder.excerpt(bytes, from, until, QUOTED_BYTES)
            firstTextLine = line
        }
    }

    private fun addGap(row: Int) {
        if (row != lastGapRow + 1) gapCount++
        if (lastGapRow < 0) firstGapRow = row
        lastGapRow = row
        addNumber(row, Double.NaN)
    }

    private fun keepText(row: Int, bytes: ByteArray, from: Int, until: Int, line: Int) {
        val pool = texts ?: TextPool(decoder).also { texts = it }
        val known = pool.dictionary.size
        val id = pool.idOf(bytes, from, until)
        isLastTextNew = id == known
        if (isLastTextNew && decoder.wasNotUtf8 && notUtf8Line == 0) notUtf8Line = line
        if (textCount == textRows.size) {
            textRows = textRows.copyOf(maxOf(16, textCount * 2))
            textIds = textIds.copyOf(textRows.size)
        }
        textRows[textCount] = row
        textIds[textCount] = id
    }

    /**
     * Adds a line to the text in [row], the last one. Returns false if that cell is not a text, or would exceed [longest]
     * bytes.
     */
    fun extendText(row: Int, bytes: ByteArray, from: Int, until: Int, longest: Int): Boolean {
        val size = lastTextSize + 1 + until - from
        if (row < 0 || row != lastTextRow || size > longest) return false
        lastTextSize = size
        val pool = texts ?: return true
        val id = textIds[textCount - 1]
        val text = pool.bytesOf(id) + LF.toByte() + bytes.copyOfRange(from, until)
        if (isLastTextNew) pool.forgetLast()
        val known = pool.dictionary.size
        textIds[textCount - 1] = pool.idOf(text, 0, text.size)
        isLastTextNew = textIds[textCount - 1] == known
        return true
    }

    /** Removes all rows, but keeps the memory for them. */
    fun clear() {
        texts = null
        lastTextRow = -1
        lastTextSize = 0
        isLastTextNew = false
        notFiniteCount = 0
        truthCount = 0
        textCount = 0
        emptyCount = 0
        gapCount = 0
        lastGapRow = -2
        firstGapRow = -1
        firstText = null
        decimalCommas = 0
        notUtf8Line = 0
        roundedCount = 0
    }

    /** Writes everything but the numbers to [out], for [append]. Returns the numbers, which still belong to this builder. */
    fun writeTo(out: BatchWriter): DoubleArray {
        out.put(notFiniteCount)
        out.put(truthCount)
        out.put(emptyCount)
        out.put(gapCount)
        out.put(firstGapRow)
        out.put(lastGapRow)
        out.put(decimalCommas)
        out.put(firstDecimalCommaLine)
        out.put(roundedCount)
        out.put(textCount)
        val first = firstText ?: return numbers
        out.put(first)
        out.put(firstTextLine)
        out.put(lastTextRow)
        out.put(lastTextSize)
        out.put(if (isLastTextNew) 1 else 0)
        val dictionary = texts?.dictionary ?: return numbers
        out.put(dictionary.size)
        for (text in dictionary) out.put(text)
        out.put(textRows, textCount)
        out.put(textIds, textCount)
        return numbers
    }

    /**
     * Adds the rows of another builder.
     *
     * @param row the index of the first of these rows, which follows all rows added here.
     * @param rows the number of these rows.
     * @param more the numbers in these rows.
     * @param details the output of [writeTo] for these rows.
     * @param linesBefore the number of lines before the first of these rows.
     */
    fun append(row: Int, rows: Int, more: DoubleArray, details: BatchReader, linesBefore: Int) {
        if (keepsNumbers) {
            if (row + rows > numbers.size) grow(row + rows)
            more.copyInto(numbers, row, 0, rows)
        } else if (sink != null) {
            for (i in 0 until rows) sink.add(row + i, more[i])
        }
        notFiniteCount += details.int()
        truthCount += details.int()
        emptyCount += details.int()
        gapCount += details.int()
        if (details.int() == 0 && row == lastGapRow + 1) gapCount--
        val gapRow = details.int()
        if (gapRow >= 0) lastGapRow = row + gapRow
        val commas = details.int()
        val commaLine = details.int()
        if (decimalCommas == 0) firstDecimalCommaLine = linesBefore + commaLine
        decimalCommas += commas
        roundedCount += details.int()
        val count = details.int()
        if (count > 0) appendTexts(row, count, details, linesBefore)
    }

    private fun appendTexts(row: Int, count: Int, details: BatchReader, linesBefore: Int) {
        val text = details.text()
        val textLine = details.int()
        if (textCount == 0) {
            firstText = text
            firstTextLine = linesBefore + textLine
        }
        lastTextRow = row + details.int()
        lastTextSize = details.int()
        isLastTextNew = details.int() != 0
        if (keepsSamples) {
            val pool = texts ?: TextPool(decoder).also { texts = it }
            val ids = IntArray(details.int())
            for (i in ids.indices) {
                val bytes = details.text().encodeToByteArray()
                val known = pool.dictionary.size
                ids[i] = pool.idOf(bytes, 0, bytes.size)
                if (i == ids.lastIndex && ids[i] < known) isLastTextNew = false
            }
            if (textCount + count > textRows.size) {
                textRows = textRows.copyOf(maxOf(textCount + count, textCount * 2))
                textIds = textIds.copyOf(textRows.size)
            }
            details.ints(textRows, textCount, count)
            details.ints(textIds, textCount, count)
            for (i in textCount until textCount + count) {
                textRows[i] += row
                textIds[i] = ids[textIds[i]]
            }
        }
        textCount += count
    }

    private fun grow(row: Int) {
        numbers = numbers.copyOf(maxOf(FIRST_ROWS, row + 1, row + row / 2))
    }

    /** Reserves memory for [rows] expected rows. */
    fun expect(rows: Int) {
        if (keepsNumbers && rows > numbers.size) numbers = numbers.copyOf(rows)
    }

    /** Returns the topic made of the first [rows] rows. The builder must not be used afterwards. */
    fun build(rows: Int, unit: String, attributes: List<String>): Topic {
        val numeric = rows - textCount - emptyCount
        val samples = when {
            !keepsNumbers || numeric == 0 -> DoubleArray(0)
            numbers.size == rows -> numbers
            else -> numbers.shortened(rows)
        }
        numbers = samples
        val column = texts?.let { TextColumn(textRows.copyOf(textCount), textIds.copyOf(textCount), it.dictionary) }
        val counts = CellCounts(
            numbers = numeric - notFiniteCount - truthCount,
            notFinite = notFiniteCount,
            truthValues = truthCount,
            texts = textCount,
            empty = emptyCount,
            gaps = gapCount,
        )
        return Topic(name, unit, attributes, samples, column ?: TextColumn.EMPTY, counts)
    }
}

private const val FIRST_ROWS = 1024
private const val QUOTED_BYTES = 60
