package badlog.cli.topic

import badlog.core.recording.CellCounts
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind

/**
 * Builds a topic with [name] and the other properties of [like], sample by sample.
 *
 * @param most the maximum number of samples.
 */
internal class TopicBuilder(private val name: String, private val like: Topic, most: Int) {
    private val samples = DoubleArray(most)
    private var textRows = IntArray(0)
    private var textIds = IntArray(0)
    private val dictionary = LinkedHashMap<String, Int>()
    private var size = 0
    private var numbers = 0
    private var notFinite = 0
    private var truthValues = 0
    private var texts = 0
    private var empty = 0
    private var gaps = 0
    private var isInGap = false

    fun addEmpty() {
        empty++
        add(Double.NaN)
    }

    /** Adds the text that a cell holds. */
    fun addText(text: String) {
        if (texts == textRows.size) {
            textRows = textRows.copyOf(maxOf(INITIAL_TEXTS, texts * 2))
            textIds = textIds.copyOf(textRows.size)
        }
        textRows[texts] = size
        textIds[texts++] = dictionary.getOrPut(text) { dictionary.size }
        add(Double.NaN)
    }

    /** Adds the number that a cell of [topic] holds. */
    fun addNumber(number: Double, topic: Topic) {
        when {
            number.isNaN() && (topic.counts.notFinite == 0 || topic.counts.empty > 0) -> empty++
            !number.isFinite() -> notFinite++
            topic.kind == TopicKind.BOOLEAN -> truthValues++
            else -> numbers++
        }
        add(number)
    }

    /** Returns the topic. [times] has the time of each sample; null if the samples belong to rows. */
    fun build(times: DoubleArray? = null): Topic {
        val column = TextColumn(textRows.copyOf(texts), textIds.copyOf(texts), dictionary.keys.toList())
        val counts = CellCounts(numbers, notFinite, truthValues, texts, empty, gaps)
        val kept = when {
            numbers + notFinite + truthValues == 0 -> DoubleArray(0)
            size == samples.size -> samples
            else -> samples.copyOf(size)
        }
        return like.copy(name = name, samples = kept, texts = column, counts = counts, times = times)
    }

    private fun add(number: Double) {
        if (number.isNaN() && !isInGap) gaps++
        isInGap = number.isNaN()
        samples[size++] = number
    }
}

/** Provides the cells of [topic]; empty cells if it is null. It is fastest in the order of rows or samples. */
internal class CellSource(private val topic: Topic?) {
    private var nextText = 0

    /** Adds the cell of [row] to [builder]. */
    fun addTo(builder: TopicBuilder, row: Int) {
        if (topic == null) return builder.addEmpty()
        val texts = topic.texts
        if (nextText > 0 && texts.rows[nextText - 1] >= row) nextText = texts.rows.binarySearch(row).let { if (it < 0) -it - 1 else it }
        while (nextText < texts.size && texts.rows[nextText] < row) nextText++
        when {
            nextText < texts.size && texts.rows[nextText] == row -> builder.addText(texts[nextText])
            topic.samples.isEmpty() -> builder.addEmpty()
            else -> builder.addNumber(topic.samples[row], topic)
        }
    }
}

private const val INITIAL_TEXTS = 16
