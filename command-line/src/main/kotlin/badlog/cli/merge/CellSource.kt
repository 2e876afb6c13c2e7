package badlog.cli.merge

import badlog.recording.Topic

/** Gives the cells of [topic], or of none, in the order of its rows. */
internal class CellSource(private val topic: Topic?) {
    private var nextText = 0

    /** Adds the cell of [row], which is behind those of the calls before, to [merged]. */
    fun addTo(merged: MergedTopic, row: Int) {
        if (topic == null) return merged.addEmpty()
        val texts = topic.texts
        while (nextText < texts.size && texts.rows[nextText] < row) nextText++
        when {
            nextText < texts.size && texts.rows[nextText] == row -> merged.addText(texts[nextText])
            topic.samples.isEmpty() -> merged.addNumber(Double.NaN, topic)
            else -> merged.addNumber(topic.samples[row], topic)
        }
    }
}
