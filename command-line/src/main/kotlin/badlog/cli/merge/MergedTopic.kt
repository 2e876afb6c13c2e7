package badlog.cli.merge

import badlog.recording.CellCounts
import badlog.recording.TextColumn
import badlog.recording.Topic
import badlog.recording.TopicKind

/** Builds the topic [name] of a merge, row by row. */
internal class MergedTopic(private val name: String, private val like: Topic, rowCount: Int) {
    private val samples = DoubleArray(rowCount)
    private val textRows = ArrayList<Int>()
    private val textIds = ArrayList<Int>()
    private val dictionary = LinkedHashMap<String, Int>()
    private var size = 0
    private var numbers = 0
    private var notFinite = 0
    private var truthValues = 0
    private var empty = 0
    private var gaps = 0
    private var isInGap = false

    /** Adds a cell without anything. */
    fun addEmpty() {
        empty++
        add(Double.NaN)
    }

    /** Adds the text that a cell holds. */
    fun addText(text: String) {
        textRows += size
        textIds += dictionary.getOrPut(text) { dictionary.size }
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

    /** The topic. */
    fun build(): Topic {
        val texts = TextColumn(textRows.toIntArray(), textIds.toIntArray(), dictionary.keys.toList())
        val counts = CellCounts(numbers, notFinite, truthValues, textRows.size, empty, gaps)
        val hasNumbers = numbers + notFinite + truthValues > 0
        return Topic(name, like.unit, like.attributes, if (hasNumbers) samples else DoubleArray(0), texts, counts)
    }

    private fun add(number: Double) {
        if (number.isNaN() && !isInGap) gaps++
        isInGap = number.isNaN()
        samples[size++] = number
    }
}
