package badlog.bag

import badlog.recording.Topic
import badlog.recording.TopicKind

/** Writes the cells of one topic, row by row, in ascending order. */
internal class TopicCells(private val topic: Topic) {
    private var nextText = 0
    private val isBoolean = topic.kind == TopicKind.BOOLEAN
    private val gapsAreNaN = gapsAreNaN(topic)

    /** Writes the cell of [row], which is behind those of the calls before. */
    fun write(row: Int, out: RowWriter) {
        val texts = topic.texts
        while (nextText < texts.size && texts.rows[nextText] < row) nextText++
        if (nextText < texts.size && texts.rows[nextText] == row) {
            out.text(texts[nextText])
        } else {
            number(if (topic.samples.isEmpty()) Double.NaN else topic.samples[row], out)
        }
    }

    private fun number(number: Double, out: RowWriter) {
        when {
            number.isNaN() && !gapsAreNaN -> out.empty()
            isBoolean && (number == 0.0 || number == 1.0) -> out.truth(number == 1.0)
            else -> out.exact(number)
        }
    }

    private companion object {
        /**
         * The samples do not tell an empty cell from one with `NaN`, but the counts do where there was but one of the two.
         * Where there were both, empty ones are the better guess, unless the topic's kind would be another without `NaN`.
         */
        fun gapsAreNaN(topic: Topic): Boolean {
            val counts = topic.counts
            if (counts.notFinite == 0) return false
            val written = counts.notFinite - topic.samples.count { it.isInfinite() }
            if (written <= 0) return false
            val emptied = counts.copy(notFinite = counts.notFinite - written, empty = counts.empty + written)
            return counts.empty == 0 || Topic.kindOf(emptied) != topic.kind
        }
    }
}
