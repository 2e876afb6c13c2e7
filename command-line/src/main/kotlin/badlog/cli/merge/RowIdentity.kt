package badlog.cli.merge

import badlog.recording.Topic

/** Tells whether a row of [one] and a row of [other] say the same in every cell; never where their topics differ. */
internal class RowIdentity(one: LogPart, other: LogPart) {
    private val areAlike = one.recording.topics.size == other.recording.topics.size
    private val pairs = one.recording.topics.map { it to other.topic(it.name) }

    /** Whether row [row] of the one is row [otherRow] of the other. */
    fun isSame(row: Int, otherRow: Int): Boolean = areAlike && pairs.all { (topic, twin) ->
        twin != null && number(topic, row) == number(twin, otherRow) && text(topic, row) == text(twin, otherRow)
    }

    private fun number(topic: Topic, row: Int) = (if (topic.samples.isEmpty()) Double.NaN else topic.samples[row]).toBits()

    private fun text(topic: Topic, row: Int): String? {
        val place = topic.texts.rows.binarySearch(row)
        return if (place < 0) null else topic.texts[place]
    }
}
